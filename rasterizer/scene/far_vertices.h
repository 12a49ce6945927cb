// Vertices so far from the origin that float has no digits left for their shape.
#pragma once

#include <cstddef>

#include "rasterizer/base/run.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// Of a triangle's size: steps of its coordinates up to this share change nothing that is seen.
inline constexpr double kHarmlessStep = 1.0 / 64;

// How many vertices have coordinates whose steps are larger than `length` (scene units), or than kHarmlessStep of
// the triangles that they make: a length that follows from the scene's bounds grows with what stretches these.
// Coordinates are those of the mesh, for an instance far away of a mesh that is small keeps its precision; each
// instance counts.
// Cost: one look at every coordinate and every triangle, on all threads; more only of a mesh of which the coarsest step
// is too large for most triangles.
std::size_t vertices_far_from_origin(const Scene& scene, double length, const Run& run = {});

}  // namespace crevice
