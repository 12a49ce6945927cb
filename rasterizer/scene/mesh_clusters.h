// Neighbouring triangles of a large mesh, and which vertices each cluster of them needs: what a view does not reach is left
// out as a whole, before a vertex of it is transformed.
#pragma once

#include "rasterizer/base/run.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// Smaller meshes are left out as a whole or not at all.
inline constexpr std::size_t kSmallestClusteredMesh = 4096;  // triangles

// Mesh::clusters of a mesh, from its triangles as they stand, in their order.
MeshClusters mesh_clusters(const Mesh& mesh, const Run& run = {});

// Of every large mesh of a scene; none of the others. To be called when the scene is made, and again after triangles have
// changed. (Vertices may move.)
void add_clusters(Scene& scene, const Run& run = {});

}  // namespace crevice
