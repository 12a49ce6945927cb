#include "tests/peers/ray_duel.h"

#include <algorithm>
#include <cmath>

#include "chapters/study/turns.h"
#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/parallel.h"

namespace crevice {

namespace {

using Hits = std::vector<std::uint8_t>;

Hits trace(Tracer tracer, const RayScene& ours, const EmbreeScene& embree, const GroupedRays& rays,
           float length, const Run& run) {
    switch (tracer) {
        case Tracer::ours:
        case Tracer::ours_again: return occluded(ours, rays.rays, length, run).occluded;
        case Tracer::embree1: return embree.occluded1(rays, length, run);
        case Tracer::embree8: return embree.occluded8(rays, length, run);
    }
    return {};
}

Run with_threads(int threads) {
    Run run;
    run.threads = threads;
    return run;
}

std::size_t count_differing(const Hits& a, const Hits& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
    return count;
}

double square(double a) { return a * a; }

// How many rays of each point are open, for two ways to trace the rays of one seed.
struct OpenRays {
    std::vector<int> ours, embree;
    long long differing = 0;
};

// The rays of `settings` through all points, a piece of the points at a time: all of them would not fit into
// memory.
OpenRays open_rays(const RayScene& ours, const EmbreeScene& embree, const std::vector<SurfacePoint>& points,
                   const RayAoSettings& settings, const Run& run) {
    constexpr std::size_t kPiece = 256;
    OpenRays open{std::vector<int>(points.size()), std::vector<int>(points.size())};
    const int pieces = static_cast<int>((points.size() + kPiece - 1) / kPiece);
    std::vector<std::size_t> differing(static_cast<std::size_t>(pieces));
    parallel_for(pieces, run, [&](int piece) {
        const Run alone = with_threads(1);
        const std::size_t first = static_cast<std::size_t>(piece) * kPiece;
        const std::size_t end = std::min(first + kPiece, points.size());
        GroupedRays rays;
        std::vector<std::size_t> ray_end;
        for (std::size_t i = first; i < end; ++i) {
            rays.add(hemisphere_rays(points[i], static_cast<std::uint32_t>(i), settings));
            ray_end.push_back(rays.rays.size());
        }
        const Hits our_hits = trace(Tracer::ours, ours, embree, rays, settings.radius, alone);
        const Hits their_hits = trace(Tracer::embree1, ours, embree, rays, settings.radius, alone);
        differing[static_cast<std::size_t>(piece)] = count_differing(our_hits, their_hits);
        std::size_t ray = 0;
        for (std::size_t i = first; i < end; ++i) {
            for (; ray < ray_end[i - first]; ++ray) {
                open.ours[i] += our_hits[ray] == 0 ? 1 : 0;
                open.embree[i] += their_hits[ray] == 0 ? 1 : 0;
            }
        }
    });
    for (const std::size_t count : differing) open.differing += static_cast<long long>(count);
    return open;
}

}  // namespace

const char* name_of(Tracer tracer) {
    switch (tracer) {
        case Tracer::ours: return "ours";
        case Tracer::ours_again: return "ours_again";
        case Tracer::embree1: return "embree1";
        case Tracer::embree8: return "embree8";
    }
    return "";
}

LengthDuel trace_in_turns(const RayScene& ours, const EmbreeScene& embree, const GroupedRays& rays,
                          float length, const std::vector<int>& thread_counts, int rounds) {
    LengthDuel duel;
    for (const int threads : thread_counts) {
        for (const Tracer tracer : kTracers) duel.times.push_back({tracer, threads, {}, {}});
    }
    std::array<Hits, kTracers.size()> hits;
    constexpr std::uint32_t kSeed = 1;
    for (int round = 0; round <= rounds; ++round) {
        for (const std::size_t turn : turn_order(duel.times.size(), round, kSeed)) {
            TracerTimes& times = duel.times[turn];
            const Clocks before = clocks();
            Hits found = trace(times.tracer, ours, embree, rays, length, with_threads(times.threads));
            const Clocks after = clocks();
            if (round > 0) {
                times.ms.push_back(after.wall_ms - before.wall_ms);
                times.cpu_ms.push_back(after.cpu_ms - before.cpu_ms);
            }
            hits[static_cast<std::size_t>(times.tracer)] = std::move(found);
        }
    }
    const auto differing = [&](Tracer tracer) {
        return count_differing(hits[0], hits[static_cast<std::size_t>(tracer)]);
    };
    duel.differing1 = differing(Tracer::embree1);
    duel.differing8 = differing(Tracer::embree8);
    return duel;
}

BuildDuel build_in_turns(const RayScene& scene, const EmbreeDevice& device, int threads, int rounds) {
    BuildDuel duel{threads, {}, {}};
    for (int round = 0; round <= rounds; ++round) {
        const double start = clocks().wall_ms;
        const Bvh bvh = build_bvh(scene.triangles, with_threads(threads));
        const double middle = clocks().wall_ms;
        const EmbreeScene embree(device, scene.triangles, threads);
        const double end = clocks().wall_ms;
        if (round == 0) continue;
        duel.ours_ms.push_back(middle - start);
        duel.embree_ms.push_back(end - middle);
    }
    return duel;
}

AoAgreement compare_ao(const RayScene& ours, const EmbreeScene& embree,
                       const std::vector<SurfacePoint>& points, RayAoSettings settings, const Run& run) {
    settings.sequence = RaySequence::independent;  // the law of their errors is known
    const OpenRays first = open_rays(ours, embree, points, settings, run);
    ++settings.seed;
    const OpenRays second = open_rays(ours, embree, points, settings, run);
    AoAgreement result;
    const double rays = settings.rays, count = static_cast<double>(points.size());
    double variance = 0, squares = 0, noisy = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double a = first.ours[i] / rays, same = first.embree[i] / rays, own = second.embree[i] / rays;
        result.ours += a / count;
        result.same_rays += same / count;
        result.own_rays += own / count;
        result.largest_same_rays = std::max(result.largest_same_rays, std::abs(a - same));
        const double p = (a + own) / 2, point_variance = p * (1 - p) / rays;
        variance += point_variance / square(count);
        if (point_variance > 0) {
            squares += square(a - own) / (2 * point_variance);
            ++noisy;
        }
    }
    result.rays = static_cast<long long>(points.size()) * settings.rays;
    result.differing = first.differing;
    result.error = std::sqrt(variance);
    const double unit = variance > 0 ? std::sqrt(2 * variance) : 1;
    result.same_rays_errors = (result.ours - result.same_rays) / unit;
    result.own_rays_errors = (result.ours - result.own_rays) / unit;
    result.point_rms_errors = noisy > 0 ? std::sqrt(squares / noisy) : 0;
    return result;
}

}  // namespace crevice
