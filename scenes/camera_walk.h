// Walks: closed smooth paths for a camera through places that somebody has chosen.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "rasterizer/scene/camera.h"

namespace crevice {

// A place on a walk, and what is looked at from there; world space.
struct WalkStop {
    glm::dvec3 eye, target;
};

// Through all stops and back to the first, each as long on the way as any other: eye and target each on a closed
// Catmull-Rom spline (Catmull & Rom 1974). `way` of the whole walk: 0 and 1 are the first stop, beyond it starts
// again. Everything else is as in `camera`. Throws UsageError for fewer than 3 stops.
Camera walking_camera(const Camera& camera, std::span<const WalkStop> stops, double way);

}  // namespace crevice
