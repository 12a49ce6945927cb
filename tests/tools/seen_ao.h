// A scene's picture, and how open ray casting finds each of its points.
#pragma once

#include <vector>

#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

inline RayAoSettings few_rays(float radius, int rays = 64) {
    RayAoSettings settings;
    settings.rays = rays;
    settings.radius = radius;
    return settings;
}

struct SeenAo {
    SurfacePoints seen;
    std::vector<float> open;  // one a point
};

// Through the scene's own camera.
inline SeenAo seen_ao(const Scene& scene, const RayAoSettings& settings, Size size = {24, 16}) {
    const GBuffer g = normal_depth(scene, scene.camera, size);
    SeenAo result{surface_points(scene, scene.camera, g), {}};
    result.open = ray_cast_ao(ray_scene(scene, scene.camera.eye), result.seen.points, settings);
    return result;
}

}  // namespace crevice
