#include "scenes/camera_walk.h"

#include <cmath>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// From b (t = 0) to c (t = 1), with the slopes that the points before and after give.
glm::dvec3 spline(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d, double t) {
    return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

}  // namespace

Camera walking_camera(const Camera& camera, std::span<const WalkStop> stops, double way) {
    if (stops.size() < 3) throw UsageError("walk: fewer than 3 stops; give places to walk through");
    const auto count = static_cast<double>(stops.size());
    const double on_way = (way - std::floor(way)) * count;
    const auto last = static_cast<std::size_t>(on_way);
    const auto stop = [&](std::size_t further) {
        return stops[(last + stops.size() - 1 + further) % stops.size()];
    };
    const WalkStop a = stop(0), b = stop(1), c = stop(2), d = stop(3);
    const double t = on_way - static_cast<double>(last);
    Camera moved = camera;
    moved.eye = spline(a.eye, b.eye, c.eye, d.eye, t);
    moved.target = spline(a.target, b.target, c.target, d.target, t);
    return moved;
}

}  // namespace crevice
