// A picture in memory: rows from top to bottom, each padded to whole groups of eight pixels so that wide
// loads need no tail.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <iterator>

#include <glm/vec3.hpp>

#include "rasterizer/base/cache_line_array.h"
#include "rasterizer/base/pixel_rect.h"
#include "rasterizer/lanes/vec3.h"

namespace crevice {

struct Size {
    int width = 0, height = 0;  // pixels
    friend bool operator==(const Size&, const Size&) = default;
};

// Rows start at multiples of this many pixels: what the widest lanes hold.
inline constexpr int kRowAlignment = 16;

constexpr int round_up(int value, int multiple) { return (value + multiple - 1) / multiple * multiple; }

// Fills pixels from a multiple of kRowAlignment on. A group of them is written at once, as a block of memory: a loop over
// pixels is compiled to one store a pixel below -O3, four times slower.
template <class T>
void fill_groups(T* first, const T* end, T value) {
    T group[kRowAlignment];
    std::fill(std::begin(group), std::end(group), value);
    for (; first != end; first += kRowAlignment) std::memcpy(first, group, sizeof group);
}

template <class T>
struct Image {
    Size size;
    int stride = 0;  // pixels from one row to the next
    CacheLineArray<T> pixels;

    Image() = default;
    Image(Size image_size, T fill) : Image(image_size) { fill_groups(pixels.begin(), pixels.end(), fill); }
    // Holds anything: for a pass that writes every pixel, padding included.
    explicit Image(Size image_size)
        : size(image_size),
          stride(round_up(image_size.width, kRowAlignment)),
          pixels(static_cast<std::size_t>(stride) * static_cast<std::size_t>(image_size.height)) {}

    bool empty() const { return pixels.empty(); }
    T* row(int y) { return pixels.data() + static_cast<std::ptrdiff_t>(y) * stride; }
    const T* row(int y) const { return pixels.data() + static_cast<std::ptrdiff_t>(y) * stride; }
    T& at(int x, int y) { return row(y)[x]; }
    const T& at(int x, int y) const { return row(y)[x]; }
};

// Asks for the cache lines of a part of a row, which come while something else is done. Inlined always: GCC takes a function
// that only asks for one without effect, and removes its calls.
template <class T>
CREVICE_INLINE void expect_row(const Image<T>& image, int x0, int x1, int y) {
    constexpr int per_line = 64 / sizeof(T);
    const T* const row = image.row(y);
    for (int x = x0; x < x1; x += per_line) __builtin_prefetch(row + x);
}
// Of the next row: a processor foresees neighbours in memory, and those of a tile's next row are far away.
template <class T>
CREVICE_INLINE void expect_next_row(const Image<T>& image, int x0, int x1, int y) {
    if (y + 1 < image.size.height) expect_row(image, x0, x1, y + 1);
}

// Fills a rectangle that begins with a whole group of pixels, and the rest of its last group.
template <class T>
void fill(Image<T>& image, PixelRect rect, T value) {
    for (int y = rect.y0; y < rect.y1; ++y) {
        T* const row = image.row(y);
        fill_groups(row + rect.x0, row + round_up(rect.x1, kRowAlignment), value);
    }
}

// Three planes, one a component: what a kernel loads several pixels at a time.
struct Image3 {
    Image<float> x, y, z;

    Image3() = default;
    Image3(Size size, glm::vec3 fill) : x(size, fill.x), y(size, fill.y), z(size, fill.z) {}
    explicit Image3(Size size) : x(size), y(size), z(size) {}

    Size size() const { return x.size; }
    bool empty() const { return x.empty(); }
    glm::vec3 at(int column, int row) const {
        return {x.at(column, row), y.at(column, row), z.at(column, row)};
    }
    void set(int column, int row, glm::vec3 value) {
        x.at(column, row) = value.x;
        y.at(column, row) = value.y;
        z.at(column, row) = value.z;
    }
};

}  // namespace crevice
