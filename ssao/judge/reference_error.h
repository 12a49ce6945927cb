// How far an AO image is from a reference that is itself noisy: all the numbers the lab reports of a method.
// In:      accessibility; a reference as two independent unbiased halves with their standard error; the
//          kinds of place the pixels show
// Unit:    that of the image; squared for MSE
// Debias:  (a - r1)(a - r2) has the mean (a - r)^2 whatever the noise of r1 and r2, as long as the two are
//          independent; (a - r)^2 itself is too large by the variance of r
// Source:  Celarek et al. 2019, "Quantifying the error of light transport algorithms", CGF 38(4): report an
//          error together with its spread; standard errors by clusters of pixels: Liang and Zeger 1986
// Cost:    that of SSIM and FLIP, about 700 operations a pixel.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "ssao/judge/reference_image.h"
#include "ssao/judge/surface_masks.h"

namespace crevice {

// A mean squared error that may be estimated below 0, and its root.
struct DebiasedSquare {
    double mean = 0;   // mean (a - r1)(a - r2); may be negative
    double error = 0;  // standard error of `mean`; infinite with fewer than two blocks

    bool below_noise() const { return mean < 0; }  // then all there is to say is that it is small
    double root() const { return mean > 0 ? std::sqrt(mean) : 0; }
};

// Standard errors take squares of so many pixels a side as one independent observation each: neighbouring
// pixels are not independent, because errors of AO are smooth. Structure larger than a block makes them too
// small still; the spread over scenes and seeds says more.
inline constexpr int kErrorBlock_px = 16;

// a - r over one region; r is the mean of the halves. NaN and infinities are counted first and their pixels
// left out of all other numbers.
struct RegionError {
    long long pixels = 0;      // of the region
    long long nan_or_inf = 0;  // of those, with a value that is not finite in the image or the reference

    double bias = 0;      // mean (a - r)
    double mae = 0;       // mean |a - r|
    double rmse_raw = 0;  // root of mean (a - r)^2, the noise of r included, and so in all that follow
    double rel_mse = 0;   // mean (a - r)^2 / (r^2 + 0.01)
    double p50 = 0, p95 = 0, p99 = 0, max_abs = 0;  // of |a - r|, see percentile()
    DebiasedSquare squared;                         // without the noise of r
    double reference_error = 0;                     // root of mean ReferenceImage::error^2

    double rmse() const { return squared.root(); }
    bool failed() const { return nan_or_inf > 0; }
};

struct ReferenceError {
    std::array<RegionError, std::size(kRegions)> regions;  // in the order of kRegions
    double ssim = 1;  // ImageError::ssim of the image and the mean reference, whole picture
    // FLIP of both as displayed(), whole picture; none with a NaN or infinity anywhere.
    std::optional<double> flip_mean, flip_p99;

    const RegionError& over(Region region) const { return regions[static_cast<std::size_t>(region)]; }
    bool failed() const { return over(Region::all).failed(); }
};

// Throws InputError when the images are not of one size, or have no pixels.
ReferenceError reference_error(const Image<float>& image, const ReferenceImage& reference,
                               const Image<SurfaceKind>& kinds);

// The two numbers of a region that many images are compared by.
struct MeanError {
    double bias = 0;         // mean (a - r)
    DebiasedSquare squared;  // mean (a - r1)(a - r2)
};

// Throws as mse_difference().
MeanError mean_error(const Image<float>& image, const ReferenceImage& reference,
                     const Image<SurfaceKind>& kinds, Region region);

// MSE of `a` minus MSE of `b`, pixel by pixel with the same reference, so that what both have in common
// cancels. Its standard error covers the noise of the images and of the reference.
struct MseDifference {
    double mean = 0, error = 0;

    // Whether the image is closer by more than three standard errors.
    bool a_is_better() const { return mean < -3 * error; }
    bool b_is_better() const { return mean > 3 * error; }
};

// Throws InputError for images of unlike sizes and, naming the pixel, for a NaN or infinity in the region.
MseDifference mse_difference(const Image<float>& a, const Image<float>& b, const ReferenceImage& reference,
                             const Image<SurfaceKind>& kinds, Region region);

}  // namespace crevice
