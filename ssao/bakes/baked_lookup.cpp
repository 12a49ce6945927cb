#include "ssao/bakes/baked_lookup.h"

#include <limits>

#include <glm/common.hpp>

#include "ssao/bakes/lightmap_ao.h"

namespace crevice {

namespace {

// How far above its point a ray starts, as a multiple of the point's largest coordinate: far above its
// rounding, and below everything that the picture tells apart.
constexpr float kAbove = 0x1p-14f;

template <class ValueAt>
std::vector<float> for_hits(std::span<const RayHit> hits, const ValueAt& value_at) {
    std::vector<float> values;
    values.reserve(hits.size());
    for (const RayHit& hit : hits) {
        const glm::vec3 weights(1 - hit.u - hit.v, hit.u, hit.v);
        values.push_back(hit.triangle < 0 ? 1.0f : value_at(static_cast<std::size_t>(hit.triangle), weights));
    }
    return values;
}

}  // namespace

std::vector<RayHit> triangles_below(const RayScene& rays, std::span<const SurfacePoint> points,
                                    const Run& run) {
    std::vector<Ray> down;
    std::vector<float> heights;
    for (const SurfacePoint& point : points) {
        const glm::vec3 size = glm::abs(point.position);
        heights.push_back(kAbove * glm::max(size.x, glm::max(size.y, size.z)));
        down.push_back({point.position + heights.back() * point.geometric_normal, -point.geometric_normal});
    }
    std::vector<RayHit> hits = closest_hits(rays, down, std::numeric_limits<float>::infinity(), run).hits;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].distance > 2 * heights[i]) hits[i] = {};
    }
    return hits;
}

std::vector<float> looked_up(const Scene& scene, const RayScene& rays, const VertexAo& ao,
                             std::span<const RayHit> hits) {
    return for_hits(hits, [&](std::size_t triangle, glm::vec3 weights) {
        const auto instance = static_cast<std::size_t>(rays.sources[triangle].instance);
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[instance].mesh)];
        const auto& v = mesh.triangles[static_cast<std::size_t>(rays.sources[triangle].triangle)];
        const std::vector<float>& at = ao.accessibility[instance];
        return weights.x * at[v[0]] + weights.y * at[v[1]] + weights.z * at[v[2]];
    });
}

std::vector<float> looked_up(const LightmapCharts& charts, const Image<float>& map,
                             std::span<const RayHit> hits) {
    return for_hits(hits, [&](std::size_t triangle, glm::vec3 weights) {
        const TriangleTexcoords& t = charts.texcoords[triangle];
        return lightmap_at(map, weights.x * t[0] + weights.y * t[1] + weights.z * t[2]);
    });
}

}  // namespace crevice
