// Accessibility baked to the vertices of a whole scene: rays once, nothing at run time, until something
// moves.
// Source: Luna, BuildVertexAmbientOcclusion; X_Jun on ray casting. Both tell of the program AmbientOcclusion of
//         Luna's book on Direct3D 11.
// In:     a Scene and the RayScene made of it
// Out:    accessibility in [0,1], 1 = open, one a vertex of each instance; 1 where no triangle uses a vertex,
//         which the tutorial divides 0 by 0 for
// Cost:   rays_cast * 50 to 150 ns of one core, and about 300 bytes a triangle while it works
//
// The tutorial: rays from the middle of each triangle; a vertex takes the mean of its triangles, each
// counting the same. That is a mean over everything the triangles reach, not what a vertex sees, so creases
// on coarse meshes are washed out, and vertices that share a place but no triangle differ.
//
// Corners: what ray_cast_ao() tends to at pixels near the vertex. Rays start on each triangle a little off
// the vertex (kInward) and go about the vertex normal. A vertex itself is no place to start: in a concave
// corner a ray lifted off one wall starts on the other, and goes through it unseen; where a thin wall stands
// on a floor no side is the outer one. On a triangle all this is decided: at a convex edge with a smooth
// normal what lies below the triangle is blocked, as it is for pixels. Triangles count by their area.
// Vertices with one position and one normal, split for their texture coordinates or their instances, share
// their triangles and so their value.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

// How far from a vertex towards a triangle's centroid rays start, as a share of the way.
inline constexpr float kInward = 1.0f / 32;

// What the tutorial casts from each triangle: uniform, about the geometric normal, no maximum distance.
inline constexpr RayAoSettings kTutorialRays = {.rays = 32,
                                                .radius = std::numeric_limits<float>::infinity(),
                                                .weight = RayWeight::uniform,
                                                .sequence = RaySequence::independent,
                                                .hemisphere = Hemisphere::geometric};

struct VertexAo {
    std::vector<std::vector<float>> accessibility;  // of each instance, one a vertex of its mesh
    long long rays_cast = 0;     // that were asked for, those below a triangle's plane included
    std::size_t lifted_far = 0;  // points lifted off their triangle by more than radius / 100
    std::size_t unused = 0;      // vertices without a triangle that has an area
};

// Called with numbers of triangles that are done.
using TrianglesDone = std::function<void(long long)>;

// Luna's way: each triangle casts settings.rays from its centroid, a vertex takes the mean of its triangles. Differs:
// the centroid is lifted by offset_origin(), not by .001 units, which is nothing for a large mesh and leads
// through the next wall of a small one. `rays`
// must be ray_scene() of `scene`. Throws UsageError.
VertexAo vertex_ao_from_centroids(const Scene& scene, const RayScene& rays,
                                  const RayAoSettings& settings = kTutorialRays, const Run& run = {},
                                  const TrianglesDone& on_progress = {});

// settings.rays are those of a vertex, shared out to its triangles (rounded up); settings.hemisphere
// `geometric` takes each triangle's normal for the vertex's. Throws UsageError.
VertexAo vertex_ao_from_corners(const Scene& scene, const RayScene& rays, const RayAoSettings& settings,
                                const Run& run = {}, const TrianglesDone& on_progress = {});

// The middles of all triangles, where vertex_ao_from_centroids() starts its rays.
std::vector<SurfacePoint> triangle_centroids(const RayScene& rays);

// The instances' values one after the other, in the order of world_mesh().
std::vector<float> joined(const VertexAo& ao);

}  // namespace crevice
