// The peer of `crevice bench --peers` for rays: what a picture's ambient occlusion costs, ours and Embree's.
// Prints one line of JSON for each thing it finds, as it finds it, and last {"kind":"end"}; see ray_peers.h.
//   embree_peer SCENE [--size WxH] [--rays N] [--rounds N] [--agreement-size WxH] [--agreement-rays N]
//               [--radius R] [--threads N] and the camera flags of `crevice render`
#include <cmath>
#include <iostream>
#include <limits>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "chapters/frame/scene_argument.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"
#include "tests/peers/ray_duel.h"

namespace {

using namespace crevice;
using Json = nlohmann::ordered_json;

struct Words {
    std::string scene, size = "192x108", agreement_size = "320x180";
    int rays = 64, rounds = 15, agreement_rays = 64, threads = 0;
    float radius = 0.5f;
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
    settings.rays = words.agreement_rays;
    settings.radius = words.radius * subject.scene.length_unit;
    Run run;
    run.threads = words.threads;
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
    Run run;
    run.threads = words.threads;
    std::vector<int> thread_counts = {1};
    if (thread_count(run) > 1) thread_counts.push_back(thread_count(run));
    const EmbreeDevice device(thread_counts.back());
    const EmbreeScene embree(device, subject.rays.triangles, thread_counts.back());
    const auto points = seen_points(subject, parse_size("--size", words.size));
    const GroupedRays rays = rays_of(points, words.rays);
    answer({{"kind", "scene"},
            {"triangles", subject.rays.triangles.size()},
            {"points", points.size()},
            {"rays", rays.rays.size()},
            {"embree", RTC_VERSION_STRING}});
    if (rays.rays.empty() && words.rounds > 0)
        throw UsageError(words.scene + ": no surface is seen; choose another --scene or --eye");
    if (words.rounds > 0) {
        answer_builds(subject, device, thread_counts, words.rounds);
        answer_traces(subject, embree, rays, thread_counts, words.rounds);
    }
    if (words.agreement_rays > 0) answer_agreement(subject, embree, words);
    answer({{"kind", "end"}});
}

}  // namespace

int main(int count, char** arguments) {
    Words words;
    CLI::App app("Ambient occlusion rays: ours and Embree's, in turns");
    app.add_option("scene", words.scene)->required();
    app.add_option("--size", words.size, "picture whose pixels' rays are timed");
    app.add_option("--rays", words.rays, "timed rays a pixel")->check(CLI::Range(1, 1 << 20));
    app.add_option("--rounds", words.rounds, "0: no times")->check(CLI::Range(0, 999));
    app.add_option("--agreement-size", words.agreement_size);
    app.add_option("--agreement-rays", words.agreement_rays, "0: none")->check(CLI::Range(0, 1 << 20));
    app.add_option("--radius", words.radius, "of the agreement, in the tutorials' units");
    app.add_option("--threads", words.threads)->check(CLI::Range(0, 1024));
    app.add_option("--eye", words.camera.eye);
    app.add_option("--target", words.camera.target);
    app.add_option("--fov-y", words.camera.fov_y);
    app.add_option("--near", words.camera.near_plane);
    app.add_option("--far", words.camera.far_plane);
    app.add_option("--ortho", words.camera.ortho);
    try {
        app.parse(count, arguments);
        measure(words);
        return 0;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
    } catch (const Error& error) {
        std::cerr << error.what() << "\n";
        return static_cast<int>(error.code);
    }
}
