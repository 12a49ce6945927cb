#include "ssao/judge/flip_filters.h"

#include <algorithm>
#include <cmath>

#include "rasterizer/lanes/approx_math.h"

namespace crevice {

namespace {

// Exponents of colour and feature difference, and the share pc of the largest colour difference that is
// spread over [0, pt] (sections 4.1.3 and 4.3).
constexpr double kColourExponent = 0.7, kFeatureExponent = 0.5, kShareBelow = 0.4, kSpreadBelow = 0.95;
// The largest colour difference there is: green to blue, Hunt-adjusted L*a*b* under D65, HyAB distance.
constexpr double kLargestDistance = 203.301654610878;
// The largest b of the three channels: all contrast filters end where that one does (table 1).
constexpr double kLargestSpread = 0.04;
// Width of the human edge detector, degrees (section 4.2).
constexpr double kFeatureWidth_deg = 0.082;

template <class WeightAt>
FlipKernel kernel_of(int radius, WeightAt weight_at) {
    FlipKernel kernel{radius, {}};
    for (int k = -radius; k <= radius; ++k) kernel.weights.push_back(weight_at(static_cast<double>(k)));
    return kernel;
}

// Positive weights add up to 1, negative ones to -1.
FlipKernel balanced(FlipKernel kernel) {
    double positive = 0, negative = 0;
    for (const double weight : kernel.weights) (weight > 0 ? positive : negative) += weight;
    for (double& weight : kernel.weights) {
        if (weight != 0) weight /= weight > 0 ? positive : -negative;
    }
    return kernel;
}

// A Gaussian, its first derivative (edges) and its second (points); across the direction of a derivative
// the filter is the Gaussian itself.
struct FeatureKernels {
    FlipKernel smooth, edge, point;
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
FlipPlane filtered_along_rows(const FlipPlane& plane, const FlipKernel& kernel) {
    const int width = plane.size.width;
    FlipPlane result(plane.size, 0.0);
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
FlipPlane filtered_along_columns(const FlipPlane& plane, const FlipKernel& kernel) {
    FlipPlane result(plane.size, 0.0);
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

// Equations 4 to 6: small differences get most of [0,1].
double spread_colour_difference(double lightness_difference) {
    const double difference = std::pow(lightness_difference, kColourExponent);
    const double largest = std::pow(kLargestDistance, kColourExponent), bend = kShareBelow * largest;
    if (difference < bend) return kSpreadBelow / bend * difference;
    return kSpreadBelow + (difference - bend) / (largest - bend) * (1 - kSpreadBelow);
}

}  // namespace

ContrastKernel contrast_kernel(double spread, double ppd) {
    const double radius = std::ceil(3 * std::sqrt(kLargestSpread / (2 * kPi * kPi)) * ppd);
    const FlipKernel raw = kernel_of(static_cast<int>(radius), [=](double k) {
        const double degrees = k / ppd;
        return std::exp(-kPi * kPi * degrees * degrees / spread);
    });
    double sum = 0;
    for (const double weight : raw.weights) sum += weight;
    return {balanced(raw), sum};
}

FlipPlane filtered(const FlipPlane& plane, const FlipKernel& along_x, const FlipKernel& along_y) {
    return filtered_along_columns(filtered_along_rows(plane, along_x), along_y);
}

double FlipFeatures::edge(int x, int y) const { return std::hypot(edge_x.at(x, y), edge_y.at(x, y)); }
double FlipFeatures::point(int x, int y) const { return std::hypot(point_x.at(x, y), point_y.at(x, y)); }

FlipFeatures flip_features(const FlipPlane& luminance, double ppd) {
    const FeatureKernels kernels = feature_kernels(ppd);
    const FlipPlane smooth = filtered_along_rows(luminance, kernels.smooth);
    return {filtered(luminance, kernels.edge, kernels.smooth), filtered_along_columns(smooth, kernels.edge),
            filtered(luminance, kernels.point, kernels.smooth),
            filtered_along_columns(smooth, kernels.point)};
}

double flip_value(double colour_distance, const FlipFeatures& a, const FlipFeatures& b, int x, int y) {
    const double strongest =
        std::max(std::fabs(a.edge(x, y) - b.edge(x, y)), std::fabs(a.point(x, y) - b.point(x, y)));
    const double feature = std::pow(strongest / std::sqrt(2.0), kFeatureExponent);
    return std::pow(spread_colour_difference(colour_distance), 1 - feature);
}

double linear_from_display(double encoded) {
    const double v = std::clamp(encoded, 0.0, 1.0);
    return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92;
}

double lab_function(double relative) {
    constexpr double kDelta = 6.0 / 29;
    const double t = std::clamp(relative, 0.0, 1.0);
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

}  // namespace crevice
