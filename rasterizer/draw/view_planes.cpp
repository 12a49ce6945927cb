#include "rasterizer/draw/view_planes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/draw/vertex_transform.h"
#include "rasterizer/scene/exact_projection.h"

namespace crevice {

namespace {

// A clip coordinate is a sum of four rounded products of rounded numbers: off by less than eight units in the last
// place of the sum of their magnitudes. Two of them make a plane.
constexpr double kRounding = 0x1p-20;

// So far beyond the side of the view: a vertex is marked as outside beyond the first pixel (OutsideBits).
constexpr double kMargin_px = 2;

// Up to here coordinates, and sums of clip coordinates, are finite floats, also where they are multiplied.
constexpr double kLargest = 1e15, kLargestClip = 1e37;

}  // namespace

ViewPlanes::ViewPlanes(const Camera& camera, Size size) {
    const glm::dmat4 rows = glm::transpose(clip_from_relative(camera, size));
    const DepthRange range = depth_range(camera);
    const glm::dvec4 one(0, 0, 0, 1);
    // a * row_a + b * row_b >= 0 within.
    const auto plane = [](double a, const glm::dvec4& row_a, double b, const glm::dvec4& row_b) {
        return Plane{a * row_a + b * row_b, glm::abs(a * row_a) + glm::abs(b * row_b)};
    };
    const double x = 1 + 2 * kMargin_px / size.width, y = 1 + 2 * kMargin_px / size.height;
    planes_ = {
        plane(1, rows[0], x, rows[3]),
        plane(-1, rows[0], x, rows[3]),
        plane(1, rows[1], y, rows[3]),
        plane(-1, rows[1], y, rows[3]),
        range.by_w ? plane(1, rows[3], -static_cast<double>(range.nearest), one) : plane(1, rows[2], 0, one),
        range.by_w ? plane(-1, rows[3], static_cast<double>(range.farthest), one)
                   : plane(-1, rows[2], 1, rows[3])};
}

std::uint8_t ViewPlanes::beyond(const CentredBox& relative) const {
    const glm::dvec3 magnitude = glm::abs(relative.centre) + relative.half;
    if (!(magnitude.x < kLargest && magnitude.y < kLargest && magnitude.z < kLargest)) return 0;
    const glm::dvec4 centre(relative.centre, 1), half(relative.half, 0), reach(magnitude, 1);
    unsigned sides = 0;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        const Plane& plane = planes_[i];
        const double terms = glm::dot(plane.magnitude, reach);
        if (!(terms < kLargestClip)) return 0;
        const double most = glm::dot(plane.equation, centre) + glm::dot(glm::abs(plane.equation), half);
        if (most < -kRounding * terms) sides |= 1u << i;
    }
    return static_cast<std::uint8_t>(sides);
}

}  // namespace crevice
