#include "ssao/rays/ray_cast_ao.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"

namespace crevice {

namespace {

constexpr int kMostRays = 1 << 20;
// Points are handed out in pieces of this many.
constexpr std::size_t kPiece = 16;
constexpr std::size_t kOctants = 8;

// The rays of one point and one replicate, those that point into the same octant together: they go through
// the same boxes. Kept from point to point so that it is allocated once a piece.
struct PointRays {
    std::vector<float> u, v, x, y, z;
    std::vector<Ray> rays;  // that leave the surface

    explicit PointRays(int count) {
        const auto padded = static_cast<std::size_t>(round_up(count, kPointGroup));
        for (auto* values : {&u, &v, &x, &y, &z}) values->resize(padded);
        rays.reserve(static_cast<std::size_t>(count));
    }
};

std::size_t octant_of(float x, float y, float z) {
    return (x < 0 ? 1u : 0u) | (y < 0 ? 2u : 0u) | (z < 0 ? 4u : 0u);
}

// Sets on.rays.
template <class F>
CREVICE_INLINE void aim_rays(const SurfacePoint& point, const SquarePoints& square,
                             const RayAoSettings& settings, std::uint32_t stream, PointRays& on) {
    const bool interpolated = settings.hemisphere == Hemisphere::interpolated;
    const TangentFrame frame = tangent_frame(interpolated ? point.normal : point.geometric_normal);
    const glm::vec3& up = point.geometric_normal;
    const auto count = static_cast<std::size_t>(square.count());
    square.fill(settings.seed, stream, on.u.data(), on.v.data());
    for (std::size_t i = 0; i < count; i += kLanes<F>) {
        const F u = load<F>(on.u.data() + i), v = load<F>(on.v.data() + i);
        const Vec3<F> d = in_frame<F>(frame, hemisphere_direction<F>(settings.weight, u, v));
        store(on.x.data() + i, d.x);
        store(on.y.data() + i, d.y);
        store(on.z.data() + i, d.z);
    }
    // With the geometric normal every direction is above the plane, but for its rounding.
    const auto above = [&](std::size_t i) {
        return !interpolated || up.x * on.x[i] + up.y * on.y[i] + up.z * on.z[i] > 0;
    };
    std::array<std::size_t, kOctants + 1> first{};
    for (std::size_t i = 0; i < count; ++i)
        first[octant_of(on.x[i], on.y[i], on.z[i]) + 1] += above(i) ? 1 : 0;
    for (std::size_t octant = 1; octant <= kOctants; ++octant) first[octant] += first[octant - 1];
    on.rays.resize(first[kOctants]);
    const glm::vec3 origin = offset_origin(point.position, up, up).origin;
    for (std::size_t i = 0; i < count; ++i) {
        if (above(i))
            on.rays[first[octant_of(on.x[i], on.y[i], on.z[i])]++] = {origin, {on.x[i], on.y[i], on.z[i]}};
    }
}

// What the rays of a point leave open, rays below the surface counted as closed.
struct OpenShare {
    double hard = 1, soft = 1;
};

// Of a point, in each of its replicates.
using OpenShares = std::array<OpenShare, kReplicates>;

// The rays that are cast from every point: so many replicates of so many rays.
struct PointCasts {
    const RayScene& scene;
    std::span<const SurfacePoint> points;
    const RayAoSettings& settings;
    const Fade* fade;  // null: hard alone
    int rays;
    std::size_t replicates;  // at most kReplicates
};

// What the rays of a point leave open, added up ray by ray, in their order: 1 for each that meets nothing.
struct OpenSum {
    double sum = 0;
    std::size_t added = 0;

    double up_to(std::size_t ray) {
        for (; added < ray; ++added) sum += 1;
        return sum;
    }
    void add(std::size_t ray, double open) {
        up_to(ray);
        sum += open;
        ++added;
    }
};

template <class F>
CREVICE_INLINE OpenShare open_share(const PointCasts& casts, const PointRays& on) {
    const bool any_hit_does = casts.fade == nullptr && !casts.scene.holes.any();
    std::size_t open = on.rays.size();
    OpenSum soft;
    for_meeting_rays<F>(
        casts.scene.bvh, on.rays, casts.settings.radius, [&](std::size_t ray) __attribute__((always_inline)) {
            if (any_hit_does) {
                --open;
                return;
            }
            const RayHit hit = nearest_solid_hit<F>(casts.scene, on.rays[ray], casts.settings.radius);
            if (hit.triangle < 0) return;  // it passes through holes alone
            --open;
            if (casts.fade != nullptr) soft.add(ray, 1.0 - casts.fade->occlusion(hit.distance));
        });
    return {static_cast<double>(open) / casts.rays,
            casts.fade == nullptr ? 1 : soft.up_to(on.rays.size()) / casts.rays};
}

// Calls take(index, shares) for every point on all threads, and done(count) when so many more have been taken. The one place
// where rays are cast for points, because it takes as long to compile as ten other files.
void cast_from_points(const PointCasts& casts, const Run& run,
                      const std::function<void(std::size_t index, const OpenShares& shares)>& take,
                      const std::function<void(long long)>& done = {}) {
    const SquarePoints square(casts.rays, casts.settings.sequence);
    parallel_blocks(casts.points.size(), kPiece, run, [&](std::size_t first, std::size_t end) {
        run_narrow_kernel(run, [&]<class F>(Lanes<F>) {
            PointRays on(casts.rays);
            for (std::size_t point = first; point < end; ++point) {
                OpenShares shares;
                for (std::size_t replicate = 0; replicate < casts.replicates; ++replicate) {
                    const auto stream = static_cast<std::uint32_t>(point * casts.replicates + replicate);
                    aim_rays<F>(casts.points[point], square, casts.settings, stream, on);
                    shares[replicate] = open_share<F>(casts, on);
                }
                take(point, shares);
            }
        });
        if (done) done(static_cast<long long>(end - first));
    });
}

}  // namespace

void validate(const RayAoSettings& s) {
    if (s.rays < 1 || s.rays > kMostRays)
        throw UsageError("rays: must lie in 1.." + std::to_string(kMostRays) + " (" + std::to_string(s.rays) +
                         "); choose another number");
    if (!(s.radius > 0))
        throw UsageError("radius: must lie in (0, inf] (" + shortest_text(s.radius) +
                         "); choose how far an occluder may be, scene units");
    if (s.fade && !(s.fade->start >= 0 && s.fade->end >= s.fade->start))
        throw UsageError("fade: must have 0 <= start <= end (" + shortest_text(s.fade->start) + ", " +
                         shortest_text(s.fade->end) + "); choose other distances");
}

std::vector<float> ray_cast_ao(const RayScene& scene, std::span<const SurfacePoint> points,
                               const RayAoSettings& settings, const Run& run) {
    validate(settings);
    validate(run);
    const Fade* const fade = settings.fade ? &*settings.fade : nullptr;
    std::vector<float> open(points.size());
    cast_from_points({scene, points, settings, fade, settings.rays, 1}, run,
                     [&](std::size_t point, const OpenShares& shares) {
                         open[point] = static_cast<float>(fade == nullptr ? shares[0].hard : shares[0].soft);
                     });
    return open;
}

AoEstimate estimate_of(const std::array<double, kReplicates>& means) {
    double sum = 0, half[2] = {0, 0};
    for (std::size_t i = 0; i < kReplicates; ++i) {
        sum += means[i];
        half[i % 2] += means[i];
    }
    const double mean = sum / kReplicates;
    double squares = 0;
    for (const double m : means) squares += (m - mean) * (m - mean);
    return {
        static_cast<float>(mean),
        static_cast<float>(std::sqrt(squares / (kReplicates * (kReplicates - 1)))),
        {static_cast<float>(half[0] / (kReplicates / 2)), static_cast<float>(half[1] / (kReplicates / 2))}};
}

std::size_t lifted_far(std::span<const SurfacePoint> points, float radius) {
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const SurfacePoint& p) {
        return offset_origin(p.position, p.geometric_normal, p.geometric_normal).offset > radius / 100;
    }));
}

RayAoReference ray_cast_reference(const RayScene& scene, std::span<const SurfacePoint> points,
                                  const RayAoSettings& settings, const Fade* fade, const Run& run,
                                  const std::function<void(long long)>& on_progress) {
    validate(settings);
    validate(run);
    const int rays = (settings.rays + kReplicates - 1) / kReplicates;
    RayAoReference reference;
    reference.hard.resize(points.size());
    if (fade != nullptr) reference.soft.resize(points.size());
    reference.rays = static_cast<long long>(points.size()) * rays * kReplicates;
    reference.lifted_far = lifted_far(points, settings.radius);
    cast_from_points(
        {scene, points, settings, fade, rays, kReplicates}, run,
        [&](std::size_t point, const OpenShares& shares) {
            std::array<double, kReplicates> hard, soft;
            for (std::size_t replicate = 0; replicate < kReplicates; ++replicate) {
                hard[replicate] = shares[replicate].hard;
                soft[replicate] = shares[replicate].soft;
            }
            reference.hard[point] = estimate_of(hard);
            if (fade != nullptr) reference.soft[point] = estimate_of(soft);
        },
        on_progress);
    return reference;
}

std::vector<Ray> hemisphere_rays(const SurfacePoint& point, std::uint32_t index,
                                 const RayAoSettings& settings) {
    validate(settings);
    PointRays on(settings.rays);
    aim_rays<float>(point, SquarePoints(settings.rays, settings.sequence), settings, index, on);
    return on.rays;
}

}  // namespace crevice
