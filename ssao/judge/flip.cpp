#include "ssao/judge/flip.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/judge/flip_filters.h"
#include "ssao/judge/metrics.h"
#include "ssao/judge/percentile.h"

namespace crevice {

namespace {

double displayed_light(const Image<float>& display, int x, int y) {
    const float value = display.at(x, y);
    if (std::isnan(value)) {
        throw InputError("FLIP of a picture with a NaN (pixel " + std::to_string(x) + ", " +
                         std::to_string(y) + "); replace it first");
    }
    return linear_from_display(static_cast<double>(value));
}

// ---- grey

// CIE L* of a luminance relative to white, in [0, 100].
double lightness(double luminance) { return 116 * lab_function(luminance) - 16; }

// What the observer sees of one grey picture: luminance as the eye blurs it, and features.
struct SeenGrey {
    FlipPlane luminance;
    FlipFeatures features;

    double distance(const SeenGrey& other, int x, int y) const {
        return std::fabs(lightness(luminance.at(x, y)) - lightness(other.luminance.at(x, y)));
    }
};
SeenGrey seen_in(const Image<float>& display, double ppd) {
    FlipPlane luminance(display.size, 0.0);  // relative to white: for grey that is linear light
    for (int y = 0; y < display.size.height; ++y) {
        for (int x = 0; x < display.size.width; ++x) luminance.at(x, y) = displayed_light(display, x, y);
    }
    const FlipKernel contrast = contrast_kernel(kAchromaticSpread, ppd).kernel;
    return {filtered(luminance, contrast, contrast), flip_features(luminance, ppd)};
}

// ---- colour

// Columns: what linear sRGB red, green and blue are in XYZ.
constexpr glm::dmat3 kXyzFromRgb = {
    {10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382},
    {8788810.0 / 24577794, 8788810.0 / 12288897, 8788810.0 / 73733382},
    {4435075.0 / 24577794, 887015.0 / 12288897, 70074185.0 / 73733382},
};

// Each of XYZ divided by white's.
glm::dmat3 relative_xyz_from_rgb() {
    glm::dmat3 matrix = kXyzFromRgb;
    const glm::dvec3 white = matrix * glm::dvec3(1);
    for (int column = 0; column < 3; ++column) matrix[column] = matrix[column] / white;
    return matrix;
}

// CIE L*a*b* of linear light under D65, its chroma times 0.01 L: equation 2, Hunt's adjustment.
glm::dvec3 hunt_lab(const glm::dmat3& relative_xyz, const glm::dvec3& rgb) {
    const glm::dvec3 xyz = relative_xyz * rgb;
    const double x = lab_function(xyz.x), y = lab_function(xyz.y), z = lab_function(xyz.z);
    const double l = 116 * y - 16;
    return {l, 0.01 * l * 500 * (x - y), 0.01 * l * 200 * (y - z)};
}

// Table 1: the Gaussians of an opponent channel's contrast sensitivity, weights a and spreads b.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity kSensitivities[3] = {
    {1, kAchromaticSpread, 0, 1}, {1, 0.0053, 0, 1}, {34.1, 0.04, 13.5, 0.025}};

FlipPlane contrast_filtered(const FlipPlane& channel, const Sensitivity& s, double ppd) {
    const ContrastKernel first = contrast_kernel(s.b1, ppd), second = contrast_kernel(s.b2, ppd);
    const auto weight = [](double a, double b, double sum) { return a * std::sqrt(kPi / b) * sum * sum; };
    const double of_first = weight(s.a1, s.b1, first.sum), of_second = weight(s.a2, s.b2, second.sum);
    FlipPlane result = filtered(channel, first.kernel, first.kernel);
    if (s.a2 == 0) return result;
    const FlipPlane other = filtered(channel, second.kernel, second.kernel);
    for (std::size_t i = 0; i < result.pixels.size(); ++i)
        result.pixels[i] =
            (of_first * result.pixels[i] + of_second * other.pixels[i]) / (of_first + of_second);
    return result;
}

// What the observer sees of one picture in colour: Hunt-adjusted L*a*b* as the eye blurs it, and features.
struct SeenColour {
    FlipPlane lab[3];
    FlipFeatures features;

    // HyAB, equation 3.
    double distance(const SeenColour& other, int x, int y) const {
        const auto apart = [&](int i) { return lab[i].at(x, y) - other.lab[i].at(x, y); };
        return std::fabs(apart(0)) + std::hypot(apart(1), apart(2));
    }
};
SeenColour seen_in(const Image3& display, double ppd) {
    const Size size = display.x.size;
    const glm::dmat3 relative_xyz = relative_xyz_from_rgb(), rgb_from_xyz = glm::inverse(relative_xyz);
    FlipPlane luminance(size, 0.0), red_green(size, 0.0), blue_yellow(size, 0.0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const glm::dvec3 xyz =
                relative_xyz * glm::dvec3(displayed_light(display.x, x, y), displayed_light(display.y, x, y),
                                          displayed_light(display.z, x, y));
            luminance.at(x, y) = xyz.y;
            red_green.at(x, y) = xyz.x - xyz.y;
            blue_yellow.at(x, y) = xyz.y - xyz.z;
        }
    }
    SeenColour seen{{contrast_filtered(luminance, kSensitivities[0], ppd),
                     contrast_filtered(red_green, kSensitivities[1], ppd),
                     contrast_filtered(blue_yellow, kSensitivities[2], ppd)},
                    flip_features(luminance, ppd)};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double of_white = seen.lab[0].at(x, y);
            const glm::dvec3 xyz(of_white + seen.lab[1].at(x, y), of_white, of_white - seen.lab[2].at(x, y));
            const glm::dvec3 lab = hunt_lab(relative_xyz, glm::clamp(rgb_from_xyz * xyz, 0.0, 1.0));
            for (int i = 0; i < 3; ++i) seen.lab[i].at(x, y) = lab[i];
        }
    }
    return seen;
}

// ---- both

template <class Seen>
Flip flip_of(const Seen& a, const Seen& b, Size size) {
    Flip result{Image<float>(size, 0.0f)};
    std::vector<double> values;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double value = flip_value(a.distance(b, x, y), a.features, b.features, x, y);
            result.map.at(x, y) = static_cast<float>(value);
            result.mean += value;
            values.push_back(value);
        }
    }
    result.mean /= static_cast<double>(values.size());
    result.p99 = percentile(std::move(values), 99);
    return result;
}

void check_observer(double ppd) {
    if (!(ppd >= 1 && ppd <= 1000)) {
        throw UsageError("pixels per degree out of range (" + shortest_text(ppd) +
                         "); give a number from 1 to 1000");
    }
}

}  // namespace

double pixels_per_degree(double distance_m, double width_m, double width_px) {
    return distance_m * (width_px / width_m) * (kPi / 180);
}

Flip flip(const Image<float>& a, const Image<float>& b, double ppd) {
    check_same_size(a, b);
    check_observer(ppd);
    return flip_of(seen_in(a, ppd), seen_in(b, ppd), a.size);
}

Flip flip(const Image3& a, const Image3& b, double ppd) {
    check_same_size(a.x, b.x);
    check_observer(ppd);
    return flip_of(seen_in(a, ppd), seen_in(b, ppd), a.x.size);
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
