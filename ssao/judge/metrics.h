// How far one image is from another: the numbers that every comparison in the lab reports.
// In:    two images of one size and component count, in any unit; errors come in the same unit
// Means: over all values of the compared pixels, components pooled, summed in double, row by row
// SSIM:  Wang et al. 2004, eq. 13, with 11x11 Gaussian windows of sigma 1.5 that lie fully inside, K1 = .01,
//        K2 = .03 and L = 1 whatever the buffer holds, on the values as they are (no display curve): to be
//        compared between like buffers only
// NaN and infinities are counted first, and their pixels left out of every other number. Where both
// images hold the same infinity (the background of view_depth) the pixel is left out too, but is equal and no
// failure. To leave out the sky of another buffer, set its pixels to the same infinity in both images.
// Cost:  about 150 multiply-adds a value, nearly all of it SSIM.
#pragma once

#include "rasterizer/base/image_io.h"

namespace crevice {

struct ImageError {
    double rmse = 0;       // [0, ~]
    double mae = 0;        // [0, ~] mean |a - b|
    double bias = 0;       // mean (a - b), signed
    double max_abs = 0;    // [0, ~] largest |a - b|
    double p99 = 0;        // [0, ~] percentile() 99 of |a - b|
    double ssim = 1;       // [-1, 1], 1: alike. Without a whole window (a side below 11 pixels, or in each
                           // a pixel left out): one window, equal weights, over all compared values
    long long pixels = 0;  // all pixels of the image
    long long compared_pixels = 0;   // those that the means are taken over
    long long differing_pixels = 0;  // those with any other bit, so -0 differs from 0
    long long nan_or_inf = 0;        // those with a NaN or infinity that is not the same infinity in both

    bool failed() const { return nan_or_inf > 0; }
    bool identical() const { return differing_pixels == 0 && !failed(); }
};

// Throws InputError naming both shapes when they differ or have no pixels.
void check_same_size(const Image<float>& a, const Image<float>& b);

// Throws like check_same_size().
ImageError compare_images(const Image<float>& a, const Image<float>& b);
ImageError compare_images(const Image3& a, const Image3& b);
ImageError compare_images(const Planes& a, const Planes& b);

// a - b per component, in float; 0 where both hold the same infinity.
Planes signed_difference(const Planes& a, const Planes& b);

// The first `limit` pixels that differ in any bit, in row order.
struct PixelPosition {
    int x = 0, y = 0;  // column and row from the top left
};
std::vector<PixelPosition> first_differing_pixels(const Planes& a, const Planes& b, std::size_t limit);

}  // namespace crevice
