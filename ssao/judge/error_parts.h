// Where a method's error comes from: from truth to the method's final image step by step, each step's change
// a part of the error.
// In:     a chain of images x_0 (truth), x_1 ... x_k (the final image), such as
//           truth -> depth buffer -> definition -> sampling -> half resolution -> storage -> blur
//         each as two independent halves where it is noisy (two sets of rays; two seeds)
// Parts:  d_i = x_i - x_{i-1}, so that they add up to D = x_k - x_0 in every pixel
// Out:    bias_i  = mean d_i;                                            adds up to the bias of D
//         share_i = mean (d_i^(1) D^(2) + d_i^(2) D^(1)) / 2;            adds up to the debiased MSE of D
//         mse_i   = mean d_i^(1) d_i^(2), the part alone;                does not add up: parts may cancel
//         A share is negative where a step takes error away. An image without a second half stands in both.
// Noise:  where both halves of D hold the same noise (x_k without a second half) it counts as error, as it
//         should when a frame has but that one image.
// Cost:   about 12 operations a pixel and part.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rasterizer/base/image.h"

namespace crevice {

struct ChainImage {
    std::string step;    // that leads to it from the image before it; of the first one, what it is
    Image<float> first;  // the image, or one half
    // The other half, independent of `first`; empty: there is no noise in the image to tell.
    Image<float> second = {};
};

struct ErrorPart {
    std::string step;
    double bias = 0;          // mean d_i
    double mse = 0;           // of the part alone, debiased: may be negative
    double rmse = 0;          // its root; 0 where mse is negative
    double share = 0;         // of the total mse, squared units; may be negative
    Image<float> difference;  // d_i, mean of both halves, of all pixels
};

struct ErrorParts {
    std::vector<ErrorPart> parts;  // one a step
    ErrorPart total;               // D; step empty, share = mse
    long long pixels = 0;          // that count
};

// `counted`: where it is not 0 a pixel counts in the means. Throws InputError when the chain has fewer than
// two images, when sizes are unlike, when no pixel counts, and for a NaN or infinity anywhere, naming step
// and pixel. Throws std::logic_error should biases or shares not add up to within 1e-12 of the sum of all
// absolute terms.
ErrorParts error_parts(std::span<const ChainImage> chain, const Image<std::uint8_t>& counted);
// All pixels count.
ErrorParts error_parts(std::span<const ChainImage> chain);

}  // namespace crevice
