// The exponent that brings an AO image closest to a reference: tells apart how much contrast a method bakes
// in from what it gets wrong.
// In:     accessibility in [0,1] (values beyond are clamped) and references of the same size
// Out:    g that minimises the mean of (a^g - r)^2 over all counted pixels of all images; 0^g is 0
// Noise:  noise of the reference that is independent of the image does not move the minimum
// How:    the best of 41 exponents spaced evenly in log g, then a golden-section search between its
//         neighbours
// Use:    fit on some scenes, apply to others; a fit tested on what it was fitted to says little.
// Cost:   about 75 powers a counted pixel, in double; libm.
#pragma once

#include <cstdint>
#include <span>

#include "rasterizer/base/image.h"

namespace crevice {

inline constexpr double kLowestExponent = 1.0 / 32, kHighestExponent = 32;

struct PowerExample {
    const Image<float>& image;
    const Image<float>& reference;
    const Image<std::uint8_t>& counted;  // where not 0
};

struct FittedPower {
    // In [kLowestExponent, kHighestExponent], to 1e-6 of itself; 1 when no other is better.
    double exponent = 1;
    double rmse_before = 0;  // root of mean (a - r)^2
    double rmse = 0;         // root of mean (a^g - r)^2
    bool at_bound = false;   // the exponent is the lowest or highest allowed: no minimum between them
};

// Throws InputError for images of unlike sizes and, naming the pixel, for a NaN or infinity that counts;
// UsageError when no pixel counts.
FittedPower fitted_power(std::span<const PowerExample> examples);

// a^exponent, with the lab's own power(): the same bits everywhere. Values are clamped to [0,1], NaN to 0.
Image<float> to_power(const Image<float>& image, double exponent);

}  // namespace crevice
