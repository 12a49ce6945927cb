#include "rasterizer/base/image.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <doctest/doctest.h>

#include "rasterizer/base/cache_line_array.h"

using namespace crevice;

namespace {

template <class T>
void check_fill(T before, T value) {
    constexpr int group = kRowAlignment;
    for (const PixelRect rect :
         {PixelRect{0, 0, 2 * group + 3, 5}, PixelRect{group, 1, group + 5, 4},
          PixelRect{2 * group, 4, 2 * group + 3, 5}, PixelRect{group, 2, 2 * group, 3},
          PixelRect{group, 2, group, 2}}) {
        Image<T> image({2 * group + 3, 5}, before);
        fill(image, rect, value);
        for (int y = 0; y < image.size.height; ++y) {
            for (int x = 0; x < image.stride; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                const bool inside = y >= rect.y0 && y < rect.y1 && x >= rect.x0 &&
                                    x < round_up(rect.x1, kRowAlignment) && rect.x0 < rect.x1;
                CHECK(image.row(y)[x] == (inside ? value : before));
            }
        }
    }
}

}  // namespace

TEST_CASE("image: a fill writes its rectangle and the rest of its last groups, and no other pixel") {
    check_fill<float>(1.5f, -0.25f);
    check_fill<std::int32_t>(7, -1);
    check_fill<std::uint8_t>(3, 255);
    check_fill<double>(0.5, 1e300);
}

TEST_CASE("cache line array: begins at a line, keeps what it holds when it grows, is copied and moved") {
    CacheLineArray<std::int32_t> numbers;
    CHECK(numbers.empty());
    for (std::int32_t i = 0; i < 1000; ++i) {
        numbers.add() = i;
        CHECK(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64 == 0);
    }
    numbers.resize(2000);
    std::fill(numbers.begin() + 1000, numbers.end(), -1);
    for (std::size_t i = 0; i < 2000; ++i) CHECK(numbers[i] == (i < 1000 ? static_cast<int>(i) : -1));

    CacheLineArray<std::int32_t> copy = numbers;
    CHECK(copy == numbers);
    copy[3] = 5;
    CHECK_FALSE(copy == numbers);
    CHECK(numbers[3] == 3);
    const CacheLineArray<std::int32_t> moved = std::move(copy);
    CHECK(moved.size() == 2000);
    CHECK(moved[3] == 5);
    CHECK(copy.empty());  // NOLINT: what was moved from is empty
    copy = moved;
    CHECK(copy == moved);
    copy.resize(2);
    CHECK(copy.size() == 2);
    CHECK_FALSE(copy == moved);
}
