// Where the pixels of a picture of one size fall in a picture of another, for linear filtering: computed in
// integers, so that equal sizes give exactly the pixel itself, and half size exactly the mean of two.
#pragma once

#include <cstdint>
#include <vector>

#include "rasterizer/base/image.h"

namespace crevice {

// For each pixel of a row (or column) of `count` pixels: its left (upper) neighbour and the weight of the
// right (lower) one among `source_count` texels, clamped at the ends. Padded to kRowAlignment.
struct LinearTaps {
    std::vector<std::int32_t> first, second;
    std::vector<float> weight_of_second;  // in [0,1)

    LinearTaps(int count, int source_count) {
        for (int i = 0; i < round_up(count, kRowAlignment); ++i) {
            // Texel position of the pixel's centre, (i + 1/2) * source / count - 1/2, over the denominator 2
            // * count.
            const std::int64_t numerator = (2 * std::int64_t{i} + 1) * source_count - count;
            const std::int64_t denominator = 2 * std::int64_t{count};
            std::int64_t whole = numerator / denominator;
            if (numerator % denominator < 0) --whole;
            const auto clamped = [&](std::int64_t texel) {
                return static_cast<std::int32_t>(
                    texel < 0 ? 0 : (texel < source_count ? texel : source_count - 1));
            };
            first.push_back(clamped(whole));
            second.push_back(clamped(whole + 1));
            weight_of_second.push_back(static_cast<float>(
                static_cast<double>(numerator - whole * denominator) / static_cast<double>(denominator)));
        }
    }
};

}  // namespace crevice
