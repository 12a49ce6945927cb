// Which instances of a scene reach into a view, and which clusters of their triangles: the vertices of the others need
// not be transformed.
#pragma once

#include <cstdint>
#include <vector>

#include "rasterizer/base/run.h"
#include "rasterizer/draw/vertex_transform.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// One an instance. A box is out of view where it lies beyond one side by more than its vertices' rounding errors. All is in
// view when nothing is to be left out, and in PositionOrders other than `relative`, whose errors are larger; so is what has a
// vertex that is not finite.
std::vector<InstanceInView> clusters_in_view(const Scene& scene, const Camera& camera, Size size,
                                             PositionOrder order, const Run& run);

// Consecutive vertices of a mesh.
struct VertexRun {
    int first, count;
    bool in_view;  // whether anything drawn may have them as corners
};

// All vertices of a mesh in order, cut where those in view and others meet, and into runs of about `longest`.
std::vector<VertexRun> vertex_runs(const Mesh& mesh, const InstanceInView& drawn, int longest);

}  // namespace crevice
