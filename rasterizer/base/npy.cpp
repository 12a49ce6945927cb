#include "rasterizer/base/npy.h"

#include <bit>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/npy_format.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

static_assert(std::endian::native == std::endian::little,
              ".npy files are written as the values lie in memory");

namespace {

using PlaneList = std::vector<const Image<float>*>;
PlaneList list(const Image<float>& image) { return {&image}; }
PlaneList list(const Image3& image) { return {&image.x, &image.y, &image.z}; }

std::string_view bytes_of(const float* values, std::size_t count) {
    return {reinterpret_cast<const char*>(values), count * sizeof(float)};
}

// Hands on the values row by row in file order: x0 y0 z0 x1 ...
void hand_on_rows(const PlaneList& planes, const PieceSink& sink) {
    const Size size = planes[0]->size;
    const std::size_t width = static_cast<std::size_t>(size.width), components = planes.size();
    std::vector<float> values(width * components);
    for (int y = 0; y < size.height; ++y) {
        for (std::size_t c = 0; c < components; ++c) {
            const float* const row = planes[c]->row(y);
            for (std::size_t x = 0; x < width; ++x) values[x * components + c] = row[x];
        }
        sink(bytes_of(values.data(), values.size()));
    }
}

void check_extent(Size size, int components) {
    const long long values = static_cast<long long>(size.width) * size.height * components;
    if (size.width > 0 && size.height > 0 && values < kMaxImageValues) return;
    throw OutputError("an image of " + std::to_string(size.width) + "x" + std::to_string(size.height) + "x" +
                      std::to_string(components) +
                      " cannot be stored; give it at least one pixel and fewer than 2^30 values");
}

// What stands before the values. Throws OutputError where they cannot be stored.
std::string npy_head(const PlaneList& planes) {
    const Size size = planes[0]->size;
    check_extent(size, static_cast<int>(planes.size()));
    std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(size.height) +
                         ", " + std::to_string(size.width) +
                         (planes.size() == 1 ? "" : ", " + std::to_string(planes.size())) + "), }";
    constexpr std::size_t kPrefix = 10, kAlignment = 64;
    while ((kPrefix + header.size() + 1) % kAlignment != 0) header += ' ';
    header += '\n';
    std::string bytes(kNpyMagic);
    bytes += {'\1', '\0', static_cast<char>(header.size() & 0xff), static_cast<char>(header.size() >> 8)};
    return bytes + header;
}

std::string npy_of(const PlaneList& planes) {
    const Size size = planes[0]->size;
    std::string bytes = npy_head(planes);
    bytes.reserve(bytes.size() + sizeof(float) * planes.size() * static_cast<std::size_t>(size.width) *
                                     static_cast<std::size_t>(size.height));
    hand_on_rows(planes, [&bytes](std::string_view row) { bytes += row; });
    return bytes;
}

void write_rows(const std::filesystem::path& path, const PlaneList& planes) {
    const std::string head = npy_head(planes);
    write_file_atomically(path, [&](const PieceSink& sink) {
        sink(head);
        hand_on_rows(planes, sink);
    });
}

}  // namespace

Planes planes_of(Image<float> image) {
    Planes planes;
    planes.push_back(std::move(image));
    return planes;
}

Planes planes_of(Image3 image) {
    Planes planes;
    for (Image<float>* plane : {&image.x, &image.y, &image.z}) planes.push_back(std::move(*plane));
    return planes;
}

std::string npy_bytes(const Image<float>& image) { return npy_of(list(image)); }
std::string npy_bytes(const Image3& image) { return npy_of(list(image)); }
std::string npy_bytes(const Planes& planes) {
    PlaneList all;
    for (const Image<float>& plane : planes) all.push_back(&plane);
    return npy_of(all);
}

void write_npy(const std::filesystem::path& path, const Image<float>& image) {
    write_rows(path, list(image));
}
void write_npy(const std::filesystem::path& path, const Image3& image) { write_rows(path, list(image)); }

}  // namespace crevice
