#include "ssao/rays/ray_cast.h"

#include <algorithm>
#include <atomic>
#include <string>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"

namespace crevice {

namespace {

// Rays are handed out in pieces of this many.
constexpr std::size_t kPiece = 1024;

std::string text_of(const glm::vec3& v) {
    return shortest_text(v.x) + ", " + shortest_text(v.y) + ", " + shortest_text(v.z);
}

void validate(const Ray& ray) {
    if (usable(ray)) return;
    throw UsageError(
        "ray: direction must be finite and not 0, its largest component in [2^-36, 2^36], origin within "
        "2^36 units (origin " +
        text_of(ray.origin) + "; direction " + text_of(ray.direction) + "); leave this ray out");
}

// Calls trace(Lanes<F>{}, first, end) for pieces of `count` rays, on all threads.
template <class Trace>
void trace_all(std::size_t count, const Run& run, const Trace& trace) {
    parallel_for(static_cast<int>((count + kPiece - 1) / kPiece), run, [&](int piece) {
        const std::size_t first = static_cast<std::size_t>(piece) * kPiece;
        run_narrow_kernel(run,
                   [&]<class F>(Lanes<F> lanes) { trace(lanes, first, std::min(first + kPiece, count)); });
    });
}

}  // namespace

OccludedRays occluded(const RayScene& scene, std::span<const Ray> rays, float max_distance, const Run& run) {
    validate(run);
    require_max_distance(max_distance);
    OccludedRays result{std::vector<std::uint8_t>(rays.size()), 0};
    std::atomic<std::size_t> refused = 0;
    trace_all(rays.size(), run, [&]<class F>(Lanes<F>, std::size_t first, std::size_t end) {
        refused += for_occluded_rays<F>(scene, rays.subspan(first, end - first), max_distance,
                                        [&](std::size_t i) { result.occluded[first + i] = 1; });
    });
    result.refused = refused;
    return result;
}

ClosestHits closest_hits(const RayScene& scene, std::span<const Ray> rays, float max_distance,
                         const Run& run) {
    validate(run);
    require_max_distance(max_distance);
    ClosestHits result{std::vector<RayHit>(rays.size()), 0};
    std::atomic<std::size_t> refused = 0;
    trace_all(rays.size(), run, [&]<class F>(Lanes<F>, std::size_t first, std::size_t end) {
        std::size_t usable_rays = 0;
        for (std::size_t i = first; i < end; ++i) {
            if (!usable(rays[i])) continue;
            result.hits[i] = nearest_solid_hit<F>(scene, rays[i], max_distance);
            ++usable_rays;
        }
        refused += end - first - usable_rays;
    });
    result.refused = refused;
    return result;
}

bool occluded(const RayScene& scene, const Ray& ray, float max_distance, const Run& run) {
    validate(ray);
    return occluded(scene, std::span(&ray, 1), max_distance, run).occluded[0] != 0;
}

RayHit closest_hit(const RayScene& scene, const Ray& ray, float max_distance, const Run& run) {
    validate(ray);
    return closest_hits(scene, std::span(&ray, 1), max_distance, run).hits[0];
}

LiftedOrigin offset_origin(glm::vec3 p, glm::vec3 geometric_normal, glm::vec3 direction) {
    const glm::vec3 size = glm::abs(p);
    const float offset = kOriginOffset * std::max(size.x, std::max(size.y, size.z));
    const bool front = glm::dot(geometric_normal, direction) >= 0;
    return {front ? p + offset * geometric_normal : p - offset * geometric_normal, offset};
}

}  // namespace crevice
