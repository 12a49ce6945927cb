// The depth buffer as a surface that rays can meet: all that a screen-space method can know of a scene.
// Source: Timonen 2013, "Screen-Space Far-Field Ambient Obscurance", compares with the same: every ray
//         against every pixel. Here the pixels are corners of triangles and the rays those of ray_cast_ao.h.
// In:     GBuffer (float32), its camera
// Out:    RayScene, relative space: two triangles between every four neighbouring pixel centres
// Rules:  neighbours whose view depths differ by more than `join` are not joined, and nothing is joined to
//         the background. With `join` the length of the rays no ray is lost by it, and what lies between a
//         near and a far surface stays unknown; an infinite one makes the plain height field, a solid without
//         end behind everything in view.
// Cost:   two triangles a pixel: about 200 bytes and 0.5 microseconds of one core each.
#pragma once

#include "ssao/rays/ray_cast.h"
#include "ssao/rays/surface_points.h"

namespace crevice {

// `join` in (0, inf], scene units. RayScene::sources holds pixels instead of meshes: instance 0, triangle 2 *
// (y * width + x) of the upper left pixel, and one more for the second of the two. Throws UsageError.
RayScene depth_mesh(const GBuffer& gbuffer, const Camera& camera, float join, const Run& run = {});

// The points of surface_points() where the depth buffer has them: at corners of depth_mesh(), to the bit.
// Rays against the depth buffer start here; from the true surface they would start below it now and then.
SurfacePoints points_on_depth_mesh(SurfacePoints points, const GBuffer& gbuffer, const Camera& camera,
                                   const Run& run = {});

}  // namespace crevice
