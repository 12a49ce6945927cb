// A small pattern of numbers that repeats over the AO map: what turns and shifts the samples of neighbouring texels
// against each other.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "rasterizer/base/hash.h"
#include "rasterizer/base/image.h"
#include "rasterizer/lanes/wide.h"

namespace crevice {

// Both sides are powers of two. A group of texels begins at a multiple of its size, so a pattern narrower than
// kRowAlignment is kept as often as fits into it and a plain load does.
class NoiseTile {
 public:
    // number(x, y) for 0 <= x < width and 0 <= y < height.
    NoiseTile(int width, int height, const std::function<float(int x, int y)>& number)
        : columns_(width < kRowAlignment ? kRowAlignment : width), rows_(height) {
        for (int y = 0; y < rows_; ++y) {
            for (int x = 0; x < columns_; ++x) values_.push_back(number(x % width, y));
        }
    }

    // Of the texels from (x, y) on.
    template <class F>
    CREVICE_INLINE F at(int x, int y) const {
        return load<F>(values_.data() + (y & (rows_ - 1)) * columns_ + (x & (columns_ - 1)));
    }

 private:
    int columns_, rows_;
    std::vector<float> values_;
};

// Numbers in [0, 1) without any pattern, 64 x 64 of them. Different streams of one seed have nothing in common.
inline NoiseTile white_noise(std::uint32_t seed, std::uint32_t stream) {
    constexpr int kSide = 64;
    return {kSide, kSide, [=](int x, int y) {
                return unit_number(hash_of(seed, stream, static_cast<std::uint32_t>(y * kSide + x)));
            }};
}

}  // namespace crevice
