// Ours and Embree in turns: the same rays, the same answers, and how long each took.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ssao/rays/ray_cast_ao.h"
#include "tests/peers/embree_scene.h"

namespace crevice {

// The ways to trace that take turns; ours twice, which shows the noise.
enum class Tracer { ours, ours_again, embree1, embree8 };
inline constexpr std::array<Tracer, 4> kTracers = {Tracer::ours, Tracer::ours_again, Tracer::embree1,
                                                   Tracer::embree8};
const char* name_of(Tracer tracer);

// The times of all rounds.
struct TracerTimes {
    Tracer tracer = Tracer::ours;
    int threads = 1;
    std::vector<double> ms, cpu_ms;  // wall clock; processor time of all threads
};

// All times of one ray length. The first round is thrown away; turns are taken in random order.
struct LengthDuel {
    std::vector<TracerTimes> times;
    // Rays that Embree, single or as packets, answers unlike ours.
    std::size_t differing1 = 0, differing8 = 0;
};
LengthDuel trace_in_turns(const RayScene& ours, const EmbreeScene& embree, const GroupedRays& rays,
                          float length, const std::vector<int>& thread_counts, int rounds);

// Wall times of building both trees, in turns.
struct BuildDuel {
    int threads = 1;
    std::vector<double> ours_ms, embree_ms;
};
BuildDuel build_in_turns(const RayScene& scene, const EmbreeDevice& device, int threads, int rounds);

// Random rays of every point: the accessibility that both find with the same rays, and with rays of their
// own.
struct AoAgreement {
    long long rays = 0, differing = 0;             // of the same rays
    double ours = 0, same_rays = 0, own_rays = 0;  // mean accessibility over all points
    // Standard error of each mean: binomial, rays and points independent.
    double error = 0;
    // Differences of the means in standard errors of a difference of independent means.
    double same_rays_errors = 0, own_rays_errors = 0;
    // Of the points, with rays of their own: root mean square of the difference in its standard errors,
    // about 1 when both mean the same. Points that both call all open or all closed are left out.
    double point_rms_errors = 0;
    double largest_same_rays = 0;  // largest difference at one point
};
AoAgreement compare_ao(const RayScene& ours, const EmbreeScene& embree,
                       const std::vector<SurfacePoint>& points, RayAoSettings settings, const Run& run);

}  // namespace crevice
