// The filters of FLIP (flip.h) and how it joins what they find: what grey and colour have in common.
// Source: Andersson et al. 2020, sections 4.1.1 (contrast sensitivity), 4.2 (features) and 4.3
#pragma once

#include <vector>

#include "rasterizer/base/image.h"

namespace crevice {

using FlipPlane = Image<double>;

// Weights of -radius .. radius. Positive ones add up to 1, negative ones to -1.
struct FlipKernel {
    int radius = 0;
    std::vector<double> weights;
};

// One Gaussian of the eye's contrast sensitivity; its two-dimensional filter is a product of this one with itself.
// `spread` is table 1's b. `sum` is what the weights added up to before they were balanced.
struct ContrastKernel {
    FlipKernel kernel;
    double sum = 1;
};
ContrastKernel contrast_kernel(double spread, double ppd);
inline constexpr double kAchromaticSpread = 0.0047;

// Beyond the border a picture goes on as its outermost pixels.
FlipPlane filtered(const FlipPlane& plane, const FlipKernel& along_x, const FlipKernel& along_y);

// How strong edges and points are along x and y in a picture's luminance, relative to white.
struct FlipFeatures {
    FlipPlane edge_x, edge_y, point_x, point_y;

    double edge(int x, int y) const;
    double point(int x, int y) const;
};
FlipFeatures flip_features(const FlipPlane& luminance, double ppd);

// Of one pixel, from the distance of its two colours as they are seen and from the features there: equations 4 to 7.
double flip_value(double colour_distance, const FlipFeatures& a, const FlipFeatures& b, int x, int y);

// An sRGB code in [0, 1] as linear light; values beyond are clamped.
double linear_from_display(double encoded);
// Of x / white: the function in CIE L*a*b*, clamped to [0, 1].
double lab_function(double relative);

}  // namespace crevice
