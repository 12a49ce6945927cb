// The whole of LDR-FLIP in colour, filter by filter as the paper writes it (Andersson et al. 2020): slow,
// nothing left out, nothing separated. What ssao/judge/flip.h is held against.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "rasterizer/base/image.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

using Colour = std::array<double, 3>;
using Colours = std::vector<Colour>;

inline constexpr double kXyzFromRgb[3][3] = {
    {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
    {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
    {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382},
};

inline double white(int row) { return kXyzFromRgb[row][0] + kXyzFromRgb[row][1] + kXyzFromRgb[row][2]; }

inline Colour relative_xyz(const Colour& rgb) {
    Colour xyz{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            xyz[static_cast<std::size_t>(i)] +=
                kXyzFromRgb[i][j] * rgb[static_cast<std::size_t>(j)] / white(i);
    }
    return xyz;
}

// Cramer's rule: columns of kXyzFromRgb, rows divided by white.
inline Colour rgb_from_relative_xyz(const Colour& xyz) {
    double m[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m[i][j] = kXyzFromRgb[i][j] / white(i);
    const auto determinant = [](const double(&a)[3][3]) {
        return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
               a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
               a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    };
    Colour rgb{};
    for (int column = 0; column < 3; ++column) {
        double replaced[3][3];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                replaced[i][j] = j == column ? xyz[static_cast<std::size_t>(i)] : m[i][j];
        rgb[static_cast<std::size_t>(column)] = determinant(replaced) / determinant(m);
    }
    return rgb;
}

inline Colour opponent_of(const Colour& display) {
    const auto linear = [](double code) {
        return code > 0.04045 ? std::pow((code + 0.055) / 1.055, 2.4) : code / 12.92;
    };
    const Colour xyz = relative_xyz({linear(display[0]), linear(display[1]), linear(display[2])});
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

inline Colour hunt_lab(const Colour& linear_rgb) {
    Colour f = relative_xyz(linear_rgb);
    const double delta = 6.0 / 29;
    for (double& t : f) t = t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    const double l = 116 * f[1] - 16;
    return {l, 0.01 * l * 500 * (f[0] - f[1]), 0.01 * l * 200 * (f[1] - f[2])};
}

inline double hyab(const Colour& a, const Colour& b) {
    return std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// sum over the window of weight(dx, dy) * value(pixel), pixels beyond the border as the nearest inside.
template <class Weight, class Value>
double windowed(Size size, int x, int y, int radius, Weight weight, Value value) {
    double sum = 0;
    for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
            sum += weight(dx, dy) * value(std::clamp(x + dx, 0, size.width - 1) +
                                          std::clamp(y + dy, 0, size.height - 1) * size.width);
        }
    }
    return sum;
}

struct ColourFlip {
    Size size;
    double ppd;

    Colours opponents(const Image<float>& grey) const {
        Colours all;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                all.push_back(opponent_of({grey.at(x, y), grey.at(x, y), grey.at(x, y)}));
        return all;
    }
    Colours opponents(const Image3& colour) const {
        Colours all;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                all.push_back(opponent_of({colour.x.at(x, y), colour.y.at(x, y), colour.z.at(x, y)}));
        return all;
    }

    Colour seen_colour(const Colours& picture, int x, int y) const {
        struct Sensitivity {
            double a1, b1, a2, b2;
        };
        constexpr Sensitivity kChannels[3] = {
            {1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
        const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
        Colour filtered{};
        for (std::size_t c = 0; c < 3; ++c) {
            const Sensitivity s = kChannels[c];
            const auto weight = [&](int dx, int dy) {
                const double squared = (dx * dx + dy * dy) / (ppd * ppd);
                return s.a1 * std::sqrt(kPi / s.b1) * std::exp(-kPi * kPi * squared / s.b1) +
                       s.a2 * std::sqrt(kPi / s.b2) * std::exp(-kPi * kPi * squared / s.b2);
            };
            const double all = windowed(size, x, y, radius, weight, [](int) { return 1.0; });
            filtered[c] = windowed(size, x, y, radius, weight,
                                   [&](int pixel) { return picture[static_cast<std::size_t>(pixel)][c]; }) /
                          all;
        }
        const double y_relative = (filtered[0] + 16) / 116;
        Colour rgb = rgb_from_relative_xyz(
            {y_relative + filtered[1] / 500, y_relative, y_relative - filtered[2] / 200});
        for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
        return hunt_lab(rgb);
    }

    // How strong edges (or points) are there: the length of the responses along x and y.
    double feature(const Colours& picture, int x, int y, bool point) const {
        const double sigma = 0.5 * 0.082 * ppd;
        const int radius = static_cast<int>(std::ceil(3 * sigma));
        const auto raw = [=](int along, int across) {
            const double gaussian = std::exp(-(along * along + across * across) / (2 * sigma * sigma));
            return (point ? along * along / (sigma * sigma) - 1 : -along) * gaussian;
        };
        double positive = 0, negative = 0;
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i) (raw(i, j) > 0 ? positive : negative) += raw(i, j);
        const auto weight = [&](int along, int across) {
            const double w = raw(along, across);
            return w > 0 ? w / positive : -w / negative;
        };
        const auto value = [&](int pixel) {
            return (picture[static_cast<std::size_t>(pixel)][0] + 16) / 116;
        };
        return std::hypot(windowed(size, x, y, radius, weight, value),
                          windowed(
                              size, x, y, radius, [&](int dx, int dy) { return weight(dy, dx); }, value));
    }

    double at(const Colours& a, const Colours& b, int x, int y) const {
        const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
        const double distance = std::pow(hyab(seen_colour(a, x, y), seen_colour(b, x, y)), 0.7);
        const double bend = 0.4 * largest;
        const double colour =
            distance < bend ? 0.95 / bend * distance : 0.95 + (distance - bend) / (largest - bend) * 0.05;
        const double strongest = std::max(std::fabs(feature(a, x, y, false) - feature(b, x, y, false)),
                                          std::fabs(feature(a, x, y, true) - feature(b, x, y, true)));
        return std::pow(colour, 1 - std::sqrt(strongest / std::sqrt(2.0)));
    }
};

}  // namespace crevice
