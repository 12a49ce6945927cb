// What a picture's pixels read from a bake: the triangle that each shows, and the stored values there.
#pragma once

#include <span>
#include <vector>

#include "ssao/bakes/lightmap_charts.h"
#include "ssao/bakes/vertex_ao.h"

namespace crevice {

// The triangle that each point lies on, and where: RayHit::u and v, the weights of its corners 1 and 2. Found
// by a short ray down onto the surface. `rays` is of the scene that the points are of, with their origin.
// RayHit::triangle is -1 for a point on no triangle.
std::vector<RayHit> triangles_below(const RayScene& rays, std::span<const SurfacePoint> points,
                                    const Run& run = {});

// One value a hit, mixed from the triangle's vertices; 1 where the hit is none.
std::vector<float> looked_up(const Scene& scene, const RayScene& rays, const VertexAo& ao,
                             std::span<const RayHit> hits);

// The same from a map, linear between its texels.
std::vector<float> looked_up(const LightmapCharts& charts, const Image<float>& map,
                             std::span<const RayHit> hits);

}  // namespace crevice
