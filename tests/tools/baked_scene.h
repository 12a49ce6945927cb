// A scene baked into a map, every step of it kept, for the tests of lightmaps.
#pragma once

#include "ssao/bakes/lightmap_ao.h"
#include "tests/tools/special_floats.h"

namespace crevice {

struct Baked {
    RayScene rays;
    LightmapCharts charts;
    LightmapPoints points;
    LightmapAo map;
};
inline Baked baked(const Scene& scene, const ChartSettings& settings, int rays, const Run& run = {}) {
    Baked b{ray_scene(scene, {0, 0, 0}, run), {}, {}, {}};
    b.charts = lightmap_charts(scene, b.rays, settings, run);
    b.points = lightmap_points(scene, b.rays, b.charts, run);
    b.map = lightmap_ao(b.rays, b.charts, b.points, {.rays = rays, .radius = kInfinity}, run);
    return b;
}

}  // namespace crevice
