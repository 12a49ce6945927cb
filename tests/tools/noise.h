// Test images full of unlike values.
#pragma once

#include <cstdint>

#include "rasterizer/base/hash.h"
#include "rasterizer/base/image.h"

namespace crevice {

// A number in [0,1) that depends on all three arguments: test images full of unlike values.
inline float noise(std::uint32_t stream, int x, int y) {
    return static_cast<float>(hash_of(stream, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) >>
                              8) /
           16777216;
}

inline Image<float> noise_image(Size size, std::uint32_t stream) {
    Image<float> image(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) image.at(x, y) = noise(stream, x, y);
    }
    return image;
}

}  // namespace crevice
