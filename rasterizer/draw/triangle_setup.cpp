#include "rasterizer/draw/triangle_setup.h"

#include <algorithm>
#include <cmath>

#include "rasterizer/draw/setup_lanes.h"

namespace crevice {

double depth_bias(const SetupSettings& settings, float z0, float z1, float z2, double z_per_x,
                  double z_per_y) {
    const DepthBias& bias = settings.bias;
    if (bias.constant == 0 && bias.slope == 0) return 0;
    double unit = 0;
    switch (settings.format) {
        case DepthFormat::d16: unit = 1 / kD16Steps; break;
        case DepthFormat::d24: unit = 1 / kD24Steps; break;
        case DepthFormat::d32f:
            unit = std::ldexp(1.0, std::ilogb(std::max({z0, z1, z2, 1e-30f})) - 23);
            break;
    }
    const double slope = kSubpixelSteps * std::max(std::fabs(z_per_x), std::fabs(z_per_y));
    // The slope may be infinite in theory; without a slope factor it must not turn the product into NaN.
    const double sum = bias.constant * unit + (bias.slope == 0 ? 0 : static_cast<double>(bias.slope) * slope);
    if (bias.clamp == 0) return sum;
    const double limit = std::fabs(static_cast<double>(bias.clamp));
    return sum > limit ? limit : (sum < -limit ? -limit : sum);
}

std::optional<SetUpTriangle> set_up_triangle(const std::array<const ProjectedVertex*, 3>& corners,
                                             const SetupSettings& settings) {
    const auto corner = [&](std::size_t i) {
        const ProjectedVertex& v = *corners[i];
        return LaneCorner<float>{v.x, v.y, v.x_rest, v.y_rest, v.z_ndc, v.inverse_w, static_cast<int>(i)};
    };
    const LaneCorner<float> given[3] = {corner(0), corner(1), corner(2)};
    const auto snapped_corner = [&](int i) { return SnappedCorner<float>{given[i].x, given[i].y}; };
    const SnappedCorner<float> a = snapped_corner(0), b = snapped_corner(1), c = snapped_corner(2);
    SnappedTriangles<float> snapped(a, b, c, true, settings.cull_back_faces);
    const std::int32_t covered = snapped.drop_uncovering(a, b, c);
    if (!snapped.drawn) return std::nullopt;
    const SetUpTriangles<float> set_up(SetupLanes<float>(given, true, settings.cull_back_faces));
    SetUpTriangle result;
    set_up.write(0, settings, result.triangle);
    result.triangle.covered = static_cast<std::uint16_t>(covered);
    result.order = set_up.order(0);
    return result;
}

}  // namespace crevice
