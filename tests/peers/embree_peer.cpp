// The peer of `crevice bench --peers` for rays: what a picture's ambient occlusion costs, ours and Embree's.
// Prints one line of JSON for each thing it finds, as it finds it, and last {"kind":"end"}; see ray_peers.h.
//   embree_peer SCENE [--size WxH] [--rays N] [--rounds N] [--agreement-size WxH] [--agreement-rays N]
//               [--radius R] [--threads N] and the camera flags of `crevice render`
#include <cmath>
#include <iostream>
#include <limits>

#include <nlohmann/json.hpp>

#include "chapters/commands/run_flags.h"
#include "chapters/terminal/command_line.h"
#include "chapters/terminal/exit_code.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"
#include "tests/peers/ray_duel.h"

namespace {

using namespace crevice;
using Json = nlohmann::ordered_json;

constexpr int kMostRays = 1 << 20;

// As they were typed.
struct Words {
    std::string scene, size = "192x108", agreement_size = "320x180";
    std::string rays = "64", rounds = "15", agreement_rays = "64", radius = "0.5", threads = "0";
    CameraFlags camera;
};

// A scene as both sides get it, and the camera that its points are seen from.
struct Subject {
    Scene scene;
    Camera camera;
    RayScene rays;
};

void answer(const Json& line) { std::cout << line.dump() << std::endl; }

// JSON has no infinity.
Json length_answer(float length) { return std::isinf(length) ? Json("unbounded") : Json(length); }

Run run_of(const Words& words) {
    return {.threads = static_cast<int>(parse_whole("--threads", words.threads, 0, 1024))};
}

std::vector<SurfacePoint> seen_points(const Subject& subject, Size size) {
    const GBuffer g = normal_depth(subject.scene, subject.camera, size);
    return surface_points(subject.scene, subject.camera, g).points;
}

GroupedRays rays_of(const std::vector<SurfacePoint>& points, int rays_a_point) {
    RayAoSettings settings;
    settings.rays = rays_a_point;
    GroupedRays rays;
    for (std::size_t i = 0; i < points.size(); ++i)
        rays.add(hemisphere_rays(points[i], static_cast<std::uint32_t>(i), settings));
    return rays;
}

void answer_builds(const Subject& subject, const EmbreeDevice& device, const std::vector<int>& thread_counts,
                   int rounds) {
    for (const int threads : thread_counts) {
        const BuildDuel duel = build_in_turns(subject.rays, device, threads, rounds);
        answer({{"kind", "build"},
                {"threads", threads},
                {"ours_ms", duel.ours_ms},
                {"embree_ms", duel.embree_ms}});
    }
}

void answer_traces(const Subject& subject, const EmbreeScene& embree, const GroupedRays& rays,
                   const std::vector<int>& thread_counts, int rounds) {
    for (const float length : {0.5f, 2.0f, std::numeric_limits<float>::infinity()}) {
        const float units = length * subject.scene.length_unit;
        const LengthDuel duel = trace_in_turns(subject.rays, embree, rays, units, thread_counts, rounds);
        for (const TracerTimes& times : duel.times) {
            answer({{"kind", "trace"},
                    {"length", length_answer(units)},
                    {"tracer", name_of(times.tracer)},
                    {"threads", times.threads},
                    {"rays", rays.rays.size()},
                    {"ms", times.ms},
                    {"cpu_ms", times.cpu_ms},
                    {"differing_embree1", duel.differing1},
                    {"differing_embree8", duel.differing8}});
        }
    }
}

void answer_agreement(const Subject& subject, const EmbreeScene& embree, const Words& words) {
    const auto points = seen_points(subject, parse_size("--agreement-size", words.agreement_size));
    RayAoSettings settings;
    settings.rays = static_cast<int>(parse_whole("--agreement-rays", words.agreement_rays, 0, kMostRays));
    if (settings.rays == 0) return;
    settings.radius = static_cast<float>(parse_number("--radius", words.radius)) * subject.scene.length_unit;
    const Run run = run_of(words);
    const AoAgreement a = compare_ao(subject.rays, embree, points, settings, run);
    answer({{"kind", "agreement"},
            {"radius", length_answer(settings.radius)},
            {"points", points.size()},
            {"rays", a.rays},
            {"differing", a.differing},
            {"ours", a.ours},
            {"embree_same_rays", a.same_rays},
            {"embree_own_rays", a.own_rays},
            {"error", a.error},
            {"same_rays_errors", a.same_rays_errors},
            {"own_rays_errors", a.own_rays_errors},
            {"point_rms_errors", a.point_rms_errors},
            {"largest_same_rays", a.largest_same_rays}});
}

void measure(const Words& words) {
    const SceneArgument argument = load_scene(words.scene, {.surfaces = false});
    const Camera camera = chosen_camera(argument, words.camera);
    const Subject subject{argument.scene, camera, ray_scene(argument.scene, camera.eye)};
    const Run run = run_of(words);
    const int rounds = static_cast<int>(parse_whole("--rounds", words.rounds, 0, 999));
    std::vector<int> thread_counts = {1};
    if (thread_count(run) > 1) thread_counts.push_back(thread_count(run));
    const EmbreeDevice device(thread_counts.back());
    const EmbreeScene embree(device, subject.rays.triangles, thread_counts.back());
    const auto points = seen_points(subject, parse_size("--size", words.size));
    const GroupedRays rays =
        rays_of(points, static_cast<int>(parse_whole("--rays", words.rays, 1, kMostRays)));
    answer({{"kind", "scene"},
            {"triangles", subject.rays.triangles.size()},
            {"points", points.size()},
            {"rays", rays.rays.size()},
            {"embree", RTC_VERSION_STRING}});
    if (rays.rays.empty() && rounds > 0)
        throw UsageError(words.scene + ": no surface is seen; choose another --scene or --eye");
    if (rounds > 0) {
        answer_builds(subject, device, thread_counts, rounds);
        answer_traces(subject, embree, rays, thread_counts, rounds);
    }
    answer_agreement(subject, embree, words);
    answer({{"kind", "end"}});
}

}  // namespace

int main(int count, char** arguments) {
    return exit_code_of([&] {
        Words words;
        CommandLine program("Ambient occlusion rays: ours and Embree's, in turns");
        program.required("SCENE", words.scene, kSceneMeaning);
        program.option("--size", words.size, "picture whose pixels' rays are timed");
        program.option("--rays", words.rays, "timed rays a pixel");
        program.option("--rounds", words.rounds, "0: no times");
        program.option("--agreement-size", words.agreement_size, "picture whose pixels' AO is compared");
        program.option("--agreement-rays", words.agreement_rays, "0: none");
        program.option("--radius", words.radius, "of the agreement, in the tutorials' units");
        program.option("--threads", words.threads, "0: all");
        add_camera_flags(program, words.camera);
        if (program.parse(count, arguments)) measure(words);
        return static_cast<int>(ExitCode::done);
    });
}
