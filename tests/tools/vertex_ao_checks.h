// Bakes of small scenes for the tests of vertex_ao.h.
#pragma once

#include <doctest/doctest.h>

#include "ssao/bakes/vertex_ao.h"
#include "tests/tools/special_floats.h"

namespace crevice {

inline constexpr RayAoSettings kRays = {.rays = 1024, .radius = kInfinity};

inline RayScene rays_of(const Scene& scene) { return ray_scene(scene, glm::dvec3(0)); }

inline VertexAo from_corners(const Scene& scene, const RayAoSettings& settings = kRays) {
    return vertex_ao_from_corners(scene, rays_of(scene), settings);
}
inline VertexAo from_centroids(const Scene& scene, const RayAoSettings& settings = kTutorialRays) {
    return vertex_ao_from_centroids(scene, rays_of(scene), settings);
}

inline void check_all(const VertexAo& ao, float expected) {
    for (std::size_t i = 0; i < ao.accessibility.size(); ++i) {
        CAPTURE(i);
        for (const float value : ao.accessibility[i]) CHECK(value == expected);
    }
}

}  // namespace crevice
