#include "ssao/judge/flip.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/judge/metrics.h"
#include "ssao/judge/percentile.h"

namespace crevice {

namespace {

// Exponents of colour and feature difference, and the share pc of the largest colour difference that is
// spread over [0, pt] (sections 4.1.3 and 4.3).
constexpr double kColourExponent = 0.7, kFeatureExponent = 0.5, kShareBelow = 0.4, kSpreadBelow = 0.95;
// The largest colour difference there is: green to blue, Hunt-adjusted L*a*b* under D65, HyAB distance.
constexpr double kLargestDistance = 203.301654610878;
// b of the achromatic contrast sensitivity, and the largest b of the three: all filters end where that one
// does (table 1).
constexpr double kAchromaticSpread = 0.0047, kLargestSpread = 0.04;
// Width of the human edge detector, degrees (section 4.2).
constexpr double kFeatureWidth_deg = 0.082;

using Plane = Image<double>;

// Weights of -radius .. radius.
struct Kernel {
    int radius = 0;
    std::vector<double> weights;
};

template <class WeightAt>
Kernel kernel_of(int radius, WeightAt weight_at) {
    Kernel kernel{radius, {}};
    for (int k = -radius; k <= radius; ++k) kernel.weights.push_back(weight_at(static_cast<double>(k)));
    return kernel;
}

// Positive weights add up to 1, negative ones to -1.
Kernel balanced(Kernel kernel) {
    double positive = 0, negative = 0;
    for (const double weight : kernel.weights) (weight > 0 ? positive : negative) += weight;
    for (double& weight : kernel.weights) {
        if (weight != 0) weight /= weight > 0 ? positive : -negative;
    }
    return kernel;
}

// The eye's contrast sensitivity for grey. Its two-dimensional filter is a product of this one with itself.
Kernel contrast_kernel(double ppd) {
    const double radius = std::ceil(3 * std::sqrt(kLargestSpread / (2 * kPi * kPi)) * ppd);
    return balanced(kernel_of(static_cast<int>(radius), [ppd](double k) {
        const double degrees = k / ppd;
        return std::exp(-kPi * kPi * degrees * degrees / kAchromaticSpread);
    }));
}

// A Gaussian, its first derivative (edges) and its second (points); across the direction of a derivative
// the filter is the Gaussian itself.
struct FeatureKernels {
    Kernel smooth, edge, point;
};
FeatureKernels feature_kernels(double ppd) {
    const double sigma = 0.5 * kFeatureWidth_deg * ppd;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto gaussian = [sigma](double k) { return std::exp(-k * k / (2 * sigma * sigma)); };
    return {
        balanced(kernel_of(radius, gaussian)),
        balanced(kernel_of(radius, [&](double k) { return -k * gaussian(k); })),
        balanced(kernel_of(radius, [&](double k) { return (k * k / (sigma * sigma) - 1) * gaussian(k); }))};
}

// Along x.
Plane filtered_along_rows(const Plane& plane, const Kernel& kernel) {
    const int width = plane.size.width;
    Plane result(plane.size, 0.0);
    std::vector<double> row(static_cast<std::size_t>(width + 2 * kernel.radius));
    for (int y = 0; y < plane.size.height; ++y) {
        for (int i = 0; i < static_cast<int>(row.size()); ++i)
            row[static_cast<std::size_t>(i)] = plane.at(std::clamp(i - kernel.radius, 0, width - 1), y);
        double* out = result.row(y);
        for (std::size_t k = 0; k < kernel.weights.size(); ++k) {
            const double weight = kernel.weights[k];
            const double* in = row.data() + k;
            for (int x = 0; x < width; ++x) out[x] += weight * in[x];
        }
    }
    return result;
}

// Along y.
Plane filtered_along_columns(const Plane& plane, const Kernel& kernel) {
    Plane result(plane.size, 0.0);
    for (int y = 0; y < plane.size.height; ++y) {
        double* out = result.row(y);
        for (std::size_t k = 0; k < kernel.weights.size(); ++k) {
            const double weight = kernel.weights[k];
            const int from = y + static_cast<int>(k) - kernel.radius;
            const double* in = plane.row(std::clamp(from, 0, plane.size.height - 1));
            for (int x = 0; x < plane.size.width; ++x) out[x] += weight * in[x];
        }
    }
    return result;
}

double linear_from_display(double encoded) {
    const double v = std::clamp(encoded, 0.0, 1.0);
    return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92;
}

// CIE L* of a luminance relative to white, in [0, 100].
double lightness(double luminance) {
    constexpr double kDelta = 6.0 / 29;
    const double t = std::clamp(luminance, 0.0, 1.0);
    const double f = t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
    return 116 * f - 16;
}

// Luminance relative to white: for grey that is linear light.
Plane luminance_of(const Image<float>& display) {
    Plane luminance(display.size, 0.0);
    for (int y = 0; y < display.size.height; ++y) {
        for (int x = 0; x < display.size.width; ++x) {
            const float value = display.at(x, y);
            if (std::isnan(value)) {
                throw InputError("FLIP of a picture with a NaN (pixel " + std::to_string(x) + ", " +
                                 std::to_string(y) + "); replace it first");
            }
            luminance.at(x, y) = linear_from_display(static_cast<double>(value));
        }
    }
    return luminance;
}

// What the observer sees of one picture: luminance as the eye blurs it, and how strong edges and points are
// along x and y.
struct Seen {
    Plane luminance, edge_x, edge_y, point_x, point_y;

    double edge(int x, int y) const { return std::hypot(edge_x.at(x, y), edge_y.at(x, y)); }
    double point(int x, int y) const { return std::hypot(point_x.at(x, y), point_y.at(x, y)); }
};
Seen seen_in(const Image<float>& display, double ppd) {
    const Plane luminance = luminance_of(display);
    const Kernel contrast = contrast_kernel(ppd);
    const FeatureKernels features = feature_kernels(ppd);
    const Plane smooth = filtered_along_rows(luminance, features.smooth);
    return {filtered_along_columns(filtered_along_rows(luminance, contrast), contrast),
            filtered_along_columns(filtered_along_rows(luminance, features.edge), features.smooth),
            filtered_along_columns(smooth, features.edge),
            filtered_along_columns(filtered_along_rows(luminance, features.point), features.smooth),
            filtered_along_columns(smooth, features.point)};
}

// Equations 4 to 6: small differences get most of [0,1].
double spread_colour_difference(double lightness_difference) {
    const double difference = std::pow(lightness_difference, kColourExponent);
    const double largest = std::pow(kLargestDistance, kColourExponent), bend = kShareBelow * largest;
    if (difference < bend) return kSpreadBelow / bend * difference;
    return kSpreadBelow + (difference - bend) / (largest - bend) * (1 - kSpreadBelow);
}

double flip_at(const Seen& a, const Seen& b, int x, int y) {
    const double colour = spread_colour_difference(
        std::fabs(lightness(a.luminance.at(x, y)) - lightness(b.luminance.at(x, y))));
    const double strongest =
        std::max(std::fabs(a.edge(x, y) - b.edge(x, y)), std::fabs(a.point(x, y) - b.point(x, y)));
    const double feature = std::pow(strongest / std::sqrt(2.0), kFeatureExponent);
    return std::pow(colour, 1 - feature);
}

}  // namespace

double pixels_per_degree(double distance_m, double width_m, double width_px) {
    return distance_m * (width_px / width_m) * (kPi / 180);
}

Flip flip(const Image<float>& a, const Image<float>& b, double ppd) {
    check_same_size(a, b);
    if (!(ppd >= 1 && ppd <= 1000)) {
        throw UsageError("pixels per degree out of range (" + shortest_text(ppd) +
                         "); give a number from 1 to 1000");
    }
    const Seen seen_a = seen_in(a, ppd), seen_b = seen_in(b, ppd);
    Flip result{Image<float>(a.size, 0.0f)};
    std::vector<double> values;
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) {
            const double value = flip_at(seen_a, seen_b, x, y);
            result.map.at(x, y) = static_cast<float>(value);
            result.mean += value;
            values.push_back(value);
        }
    }
    result.mean /= static_cast<double>(values.size());
    result.p99 = percentile(std::move(values), 99);
    return result;
}

Image<float> displayed(const Image<float>& accessibility) {
    Image<float> display = accessibility;
    for (float& value : display.pixels) {
        if (std::isnan(value)) continue;
        value = std::floor(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f) / 255;
    }
    return display;
}

}  // namespace crevice
