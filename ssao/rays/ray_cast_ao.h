// Ray-cast ambient occlusion: of many rays into the hemisphere over a point, the share that meets nothing.
// Source: X_Jun and Luna on ray casting, both with uniform weight; with cosine weight it is the irradiance of a
//         white sky (Landis 2002)
// In:     RayScene; points in the space of its positions; scene units
// Out:    accessibility in [0,1], 1 = open, one a point
// Rules:  directions lie about the interpolated normal (Hemisphere); those below the triangle's own plane are
//         blocked, by the surface they start on. Origins are lifted along the geometric normal
//         (offset_origin). What is met further away than `radius` does not occlude.
// Cost:   a ray is 50 to 150 ns of one core; see ray_cast.h.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "ssao/rays/hemisphere_directions.h"
#include "ssao/rays/ray_cast.h"
#include "ssao/rays/surface_points.h"

namespace crevice {

enum class Hemisphere {
    interpolated,  // about the vertex normals' mean: what is shaded
    geometric,     // about the triangle's own normal
};

// How much an occluder at a distance counts: fully up to `start`, not at all from `end` on, linear between;
// start = end is a step. The tutorials' fade, over the length of a ray instead of a difference of depths.
struct Fade {
    float start = 0, end = 0;  // 0 <= start <= end, scene units

    double occlusion(double distance) const {
        if (distance <= start) return 1;
        return distance < end ? (end - distance) / (double(end) - start) : 0;
    }
};

struct RayAoSettings {
    int rays = 1024;      // [1, 2^20] a point
    float radius = 0.5f;  // (0, inf] scene units; how far an occluder may be
    RayWeight weight = RayWeight::cosine;
    RaySequence sequence = RaySequence::sobol;
    Hemisphere hemisphere = Hemisphere::interpolated;
    std::uint32_t seed = 1;
    std::optional<Fade> fade = {};  // how occluders within the radius count; none: fully
};

// Throws UsageError naming the first member out of its range.
void validate(const RayAoSettings& settings);

// One a point.
std::vector<float> ray_cast_ao(const RayScene& scene, std::span<const SurfacePoint> points,
                               const RayAoSettings& settings = {}, const Run& run = {});

// ---- references: the same with an error

// A mean over independent replicates, and how far it may be off.
struct AoEstimate {
    float mean = 1;
    float error = 0;                     // standard error of the mean
    std::array<float, 2> half = {1, 1};  // the means of half the replicates each: two independent references
};

// The rays of a reference are drawn in this many independent scrambles.
inline constexpr int kReplicates = 8;

// Mean and standard error of kReplicates means.
AoEstimate estimate_of(const std::array<double, kReplicates>& means);

struct RayAoReference {
    std::vector<AoEstimate> hard;  // cut at the radius
    std::vector<AoEstimate> soft;  // weighted by the fade, cut at the radius; empty without a fade
    long long rays = 0;          // that were asked for, all points together; rays a point is rounded up to a
                                 // multiple of kReplicates
    std::size_t lifted_far = 0;  // lifted_far()
};

// How many points rays leave more than radius / 100 above their surface: too far from the origin for a float.
std::size_t lifted_far(std::span<const SurfacePoint> points, float radius);

// `fade` null: hard only, which is faster. on_progress is called with numbers of points that are done, from any
// thread. Throws UsageError.
RayAoReference ray_cast_reference(const RayScene& scene, std::span<const SurfacePoint> points,
                                  const RayAoSettings& settings, const Fade* fade, const Run& run = {},
                                  const std::function<void(long long)>& on_progress = {});

// The rays of points[index] as ray_cast_ao() traces them, those below the surface left out. To step through, and
// for other ways to trace them.
std::vector<Ray> hemisphere_rays(const SurfacePoint& point, std::uint32_t index,
                                 const RayAoSettings& settings);

}  // namespace crevice
