// Rays against all triangles of a scene: is anything in the way, and what is met first.
// Source: bvh.h, ray_triangle.h, packet_traverse.h, ray_traverse.h
// In:     a Scene; rays relative to RayScene::origin, scene units
// Out:    hit or not, distance, triangle: the ones that testing every triangle would give, whatever the tree,
//         the threads, the lanes or the instruction set
// Cost:   100 bytes a triangle in all, 180 while it is built. Rays go fastest where up to 64 in a row start
//         in one point, sorted by the signs of their directions: all rays of a pixel, then those of the next.
//         Where only eight in a row do, a ray takes 1.6 to 2.5 times as long.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/base/run.h"
#include "rasterizer/scene/scene.h"
#include "ssao/rays/bvh.h"
#include "ssao/rays/packet_traverse.h"
#include "ssao/rays/ray_holes.h"

namespace crevice {

// Where a triangle comes from.
struct TriangleSource {
    std::int32_t instance = 0;  // index into Scene::instances
    std::int32_t triangle = 0;  // index into the triangles of the instance's mesh
    std::int32_t material = 0;  // index into Scene::materials
};

// All triangles of a scene, world axes, ready for rays.
struct RayScene {
    glm::dvec3 origin = glm::dvec3(0);    // world space; what all positions here are relative to
    std::vector<Corners> triangles;       // corners in the order of the mesh
    std::vector<TriangleSource> sources;  // one a triangle
    std::vector<bool> mirrored;           // one an instance: whether its matrix turns front faces round
    std::size_t degenerate = 0;           // triangles left out because they have no area
    std::size_t not_finite = 0;           // triangles left out for a corner that is NaN or beyond kRayReach
    Bvh bvh;                              // of `triangles`
    RayHoles holes;                       // of cut-outs: rays go through them
};

// For kernels: the first solid thing met.
template <class F>
CREVICE_INLINE RayHit nearest_solid_hit(const RayScene& scene, const Ray& ray, float max_distance) {
    if (!scene.holes.any()) return nearest_hit<F>(scene.bvh, ray, max_distance);
    return nearest_hit<F>(
        scene.bvh, ray,
        max_distance, [&](std::int32_t triangle, float u, float v) __attribute__((always_inline)) {
            const TriangleSource& source = scene.sources[static_cast<std::size_t>(triangle)];
            return is_solid(scene.holes, triangle, source.material, u, v);
        });
}

// For kernels: calls body(i) for each ray that meets anything solid at a distance in (0, max_distance], in their order.
// Returns how many rays are not usable(); those meet nothing.
template <class F, class Body>
CREVICE_INLINE std::size_t for_occluded_rays(const RayScene& scene, std::span<const Ray> rays,
                                             float max_distance, const Body& body) {
    return for_meeting_rays<F>(
        scene.bvh, rays, max_distance, [&](std::size_t i) __attribute__((always_inline)) {
            if (scene.holes.any() && nearest_solid_hit<F>(scene, rays[i], max_distance).triangle < 0) return;
            body(i);
        });
}

// Triangles are transformed and brought to `origin` in double, then rounded to float: with the eye of the
// camera as origin, what is near it keeps its bits however far away the scene is. Triangles come in the order
// of instances and meshes. Throws UsageError when `origin` is not finite or `run` not valid.
RayScene ray_scene(const Scene& scene, glm::dvec3 origin, const Run& run = {});

// Unit normal of a triangle's plane, on the side that its corners are clockwise seen from: its front.
glm::vec3 geometric_normal(const RayScene& scene, std::int32_t triangle);

// Whether a triangle is met at a distance in (0, max_distance]; max_distance may be +inf. Distances are
// multiples of the direction's length. Throws UsageError for a ray that is not usable() (direction 0 or not
// finite or out of range, origin not finite or beyond kRayReach) and for a max_distance that is not above 0.
bool occluded(const RayScene& scene, const Ray& ray, float max_distance, const Run& run = {});

// The first triangle met there, or none (RayHit::triangle = -1); at equal distances the lowest index. Throws
// like occluded().
RayHit closest_hit(const RayScene& scene, const Ray& ray, float max_distance, const Run& run = {});

// The answers for many rays, and how many of them were not usable(); those meet nothing.
struct OccludedRays {
    std::vector<std::uint8_t> occluded;  // 1 or 0, one a ray
    std::size_t refused = 0;
};
struct ClosestHits {
    std::vector<RayHit> hits;  // one a ray
    std::size_t refused = 0;
};

// On all threads; of occluded() those together that follow each other and start in the same point. Throws UsageError
// for a max_distance that is not above 0 and for a `run` that is not valid.
OccludedRays occluded(const RayScene& scene, std::span<const Ray> rays, float max_distance,
                      const Run& run = {});
ClosestHits closest_hits(const RayScene& scene, std::span<const Ray> rays, float max_distance,
                         const Run& run = {});

// ---- where a ray may start

// A point of a surface, lifted off it on the side the ray goes to.
struct LiftedOrigin {
    glm::vec3 origin;
    float offset;  // scene units, how far it was lifted: a caller warns when it exceeds radius / 100
};

// By how much, as a multiple of the largest |coordinate| of p: eight times the rounding of a float. The
// rounding of p and of the sum take up to sqrt(3) of it; the rest is for how p was found.
inline constexpr float kOriginOffset = 8 * 0x1p-24f;

// `p` as RayScene has positions, `geometric_normal` unit, of either side. Nothing but the scale of p decides
// the offset, so that a scene in other units has the same rays.
LiftedOrigin offset_origin(glm::vec3 p, glm::vec3 geometric_normal, glm::vec3 direction);

}  // namespace crevice
