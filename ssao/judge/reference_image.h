// A picture that other pictures are compared with, noisy itself, and how far it may be off.
#pragma once

#include <array>

#include "rasterizer/base/image.h"

namespace crevice {

struct ReferenceImage {
    Image<float> mean;
    Image<float> error;  // standard error of the mean, of each pixel
    // Means of half the replicates each: unbiased, independent of each other.
    std::array<Image<float>, 2> half;
};

}  // namespace crevice
