#include "rasterizer/draw/depth_precision.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {

namespace {

constexpr double kHalfUlp = 0x1p-24;  // u, of a float in [1, 2)

// ndc_depth = a + b / z or, orthographic, a + b z.
struct DepthCurve {
    double near_plane, far_plane, a, b;
    bool perspective;

    explicit DepthCurve(const Camera& camera)
        : near_plane(camera.near_plane),
          far_plane(camera.far_plane),
          perspective(camera.projection == Projection::perspective) {
        validate(camera);
        const double n = near_plane, f = far_plane;
        const bool reversed = camera.reversed_z;
        if (perspective) {
            a = (reversed ? -n : f) / range();
            b = (reversed ? n * f : -n * f) / range();
        } else {
            a = (reversed ? f : -n) / range();
            b = (reversed ? -1 : 1) / range();
        }
    }
    double ndc(double z) const { return std::clamp(perspective ? a + b / z : a + b * z, 0.0, 1.0); }
    double view_depth(double ndc) const { return perspective ? b / (ndc - a) : (ndc - a) / b; }
    double view_per_ndc(double z) const { return perspective ? z * z / std::fabs(b) : 1 / std::fabs(b); }
    // How far z' can be from z when ndc depth is off by no more than this; both lie between the planes.
    double bound(double z, double ndc_error) const {
        const double first_order = view_per_ndc(z) * ndc_error, all = range();
        if (!perspective) return std::min(first_order, all);
        return first_order < z ? std::min(first_order / (1 - first_order / z), all) : all;
    }
    double range() const { return far_plane - near_plane; }
};

double step_in_ndc(DepthFormat format, double ndc) {
    if (format == DepthFormat::d16) return 1 / kD16Steps;
    if (format == DepthFormat::d24) return 1 / kD24Steps;
    // Of a float below 1, the farthest code.
    const float at = std::min(static_cast<float>(ndc), 1 - 0x1p-24f);
    return double(float_from_bits(float_bits(at) + 1)) - double(at);
}

}  // namespace

StoredDepth stored_depth(const Camera& camera, DepthFormat format, double z) {
    const DepthCurve curve(camera);
    const auto ndc = static_cast<float>(curve.ndc(z));
    const std::int32_t code = depth_code(format, ndc, 0.0);
    return {ndc, code, depth_from_code<float>(format, code)};
}

double view_depth_of(const Camera& camera, double ndc) { return DepthCurve(camera).view_depth(ndc); }

DepthError depth_error(const Camera& camera, DepthFormat format, double z) {
    const DepthCurve curve(camera);
    const auto [ndc, code, stored] = stored_depth(camera, format, z);
    const double rebuilt = curve.view_depth(stored);
    const auto a = static_cast<float>(curve.a), b = static_cast<float>(curve.b);
    const float in_float = curve.perspective ? b / (stored - a) : (stored - a) / b;
    const double roundings = 2 * kHalfUlp * std::max(std::fabs(curve.a), double(ndc));
    return {std::fabs(double(static_cast<float>(rebuilt)) - z), std::fabs(double(in_float) - z),
            curve.bound(z, step_in_ndc(format, ndc) / 2 + roundings) + 3 * kHalfUlp * z};
}

double depth_step(const Camera& camera, DepthFormat format, double z) {
    const DepthCurve curve(camera);
    return curve.view_per_ndc(z) * step_in_ndc(format, curve.ndc(z));
}

double largest_step_up_to(const Camera& camera, DepthFormat format, double z) {
    if (!camera.reversed_z || format != DepthFormat::d32f) return depth_step(camera, format, z);
    // Floats have finer steps where they are smaller, reversed depths further away. Orthographic, the coarsest are those at
    // the near plane; in perspective a step of this share of a depth is no more than this share of z.
    constexpr double kLargestShare = 0x1p-23, kRounding = 1 + 0x1p-20;
    return camera.projection == Projection::orthographic ? depth_step(camera, format, camera.near_plane)
                                                         : z * kLargestShare * kRounding;
}

double depth_of_step(const Camera& camera, DepthFormat format, double length) {
    constexpr double kRatio = 1 + 1.0 / 2048;
    for (double z = camera.near_plane; z <= camera.far_plane; z *= kRatio) {
        if (depth_step(camera, format, z) > length) return z;
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace crevice
