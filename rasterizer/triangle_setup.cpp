#include "rasterizer/triangle_setup.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace crevice {

namespace {

// D3D11.3 functional spec 15.10; `slope` is max(|dz/dx|, |dz/dy|) per pixel.
double bias_of(const SetupSettings& settings, float largest_z, double slope) {
    const DepthBias& bias = settings.bias;
    if (bias.constant == 0 && bias.slope == 0) return 0;
    double unit = 0;
    switch (settings.format) {
        case DepthFormat::d16: unit = 1 / kD16Steps; break;
        case DepthFormat::d24: unit = 1 / kD24Steps; break;
        case DepthFormat::d32f: unit = std::ldexp(1.0, std::ilogb(std::max(largest_z, 1e-30f)) - 23); break;
    }
    // The slope may be infinite in theory; without a slope factor it must not turn the product into NaN.
    const double sum = bias.constant * unit + (bias.slope == 0 ? 0 : static_cast<double>(bias.slope) * slope);
    if (bias.clamp == 0) return sum;
    const double limit = std::fabs(static_cast<double>(bias.clamp));
    return sum > limit ? limit : (sum < -limit ? -limit : sum);
}

// Undoing the snap moves a corner value by at most this part of the triangle's range.
constexpr double kSnapReach = 0.25;

// A quantity that is affine on the screen: its slope per 1/256 pixel, and its values at the snapped corners.
struct Plane {
    double per_x, per_y;
    std::array<float, 3> at_corner;
};

Plane plane_through(const std::array<const ProjectedVertex*, 3>& corners,
                    const std::array<std::uint8_t, 3>& order, float ProjectedVertex::*quantity,
                    double inverse_area) {
    const ProjectedVertex &a = *corners[order[0]], &b = *corners[order[1]], &c = *corners[order[2]];
    const double low = std::min({a.*quantity, b.*quantity, c.*quantity});
    const double high = std::max({a.*quantity, b.*quantity, c.*quantity});
    const double to_b = static_cast<double>(b.*quantity) - a.*quantity,
                 to_c = static_cast<double>(c.*quantity) - a.*quantity;
    Plane plane;
    plane.per_x = (to_b * (c.y - a.y) - to_c * (b.y - a.y)) * inverse_area;
    plane.per_y = (to_c * (b.x - a.x) - to_b * (c.x - a.x)) * inverse_area;
    for (std::size_t i = 0; i < 3; ++i) {
        // Slivers have wild slopes: their corners keep near the range of the triangle, and on their side of
        // zero.
        const ProjectedVertex& corner = *corners[order[i]];
        const double reach = kSnapReach * (high - low);
        const double shift = -(plane.per_x * corner.x_rest + plane.per_y * corner.y_rest);
        const double moved = corner.*quantity + std::min(std::max(shift, -reach), reach);
        plane.at_corner[i] = static_cast<float>(std::max(moved, 0.5 * low));
    }
    return plane;
}

}  // namespace

std::optional<SetUpTriangle> set_up_triangle(const std::array<const ProjectedVertex*, 3>& corners,
                                             const SetupSettings& settings) {
    const ProjectedVertex &a = *corners[0], &b = *corners[1], &c = *corners[2];
    const std::int64_t doubled_area =
        std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
    if (doubled_area == 0) return std::nullopt;
    if (doubled_area < 0 && settings.cull_back_faces) return std::nullopt;
    const PixelSpan columns = covered_centres(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}));
    const PixelSpan rows = covered_centres(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}));
    if (columns.first > columns.last || rows.first > rows.last) return std::nullopt;

    SetUpTriangle result{.triangle = {}, .order = {0, 1, 2}};
    ScreenTriangle& t = result.triangle;
    t.back_facing = doubled_area < 0;
    if (t.back_facing) std::swap(result.order[1], result.order[2]);
    const auto above = [&](std::uint8_t i, std::uint8_t j) {
        return std::pair(corners[i]->y, corners[i]->x) < std::pair(corners[j]->y, corners[j]->x);
    };
    const auto& o = result.order;
    const int top = above(o[0], o[1]) ? (above(o[0], o[2]) ? 0 : 2) : (above(o[1], o[2]) ? 1 : 2);
    std::rotate(result.order.begin(), result.order.begin() + top, result.order.end());

    for (std::size_t i = 0; i < 3; ++i) {
        const ProjectedVertex& corner = *corners[result.order[i]];
        t.x[i] = corner.x;
        t.y[i] = corner.y;
    }
    const double area = static_cast<double>(t.back_facing ? -doubled_area : doubled_area);
    const double inverse_area = 1 / area;
    const Plane z = plane_through(corners, o, &ProjectedVertex::z_ndc, inverse_area);
    const Plane inverse_w = plane_through(corners, o, &ProjectedVertex::inverse_w, inverse_area);
    t.z0 = z.at_corner[0];
    t.z_per_e1 = static_cast<float>((static_cast<double>(z.at_corner[1]) - z.at_corner[0]) * inverse_area);
    t.z_per_e2 = static_cast<float>((static_cast<double>(z.at_corner[2]) - z.at_corner[0]) * inverse_area);
    t.inverse_w = inverse_w.at_corner;
    t.doubled_area = static_cast<float>(area);
    t.clipped = -1;
    t.depth_bias = bias_of(settings, std::max({t.z0, z.at_corner[1], z.at_corner[2]}),
                           kSubpixelSteps * std::max(std::fabs(z.per_x), std::fabs(z.per_y)));
    return result;
}

}  // namespace crevice
