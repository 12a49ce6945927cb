#include "chapters/frame/frame.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"
#include "tests/tools/tutorial_settings.h"

using namespace crevice;

namespace {

FrameRequest request_for(const char* method, Size size) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method(method);
    request.settings = settings_of(*request.method);
    return request;
}

std::vector<std::string> pass_names(const Frame& frame) {
    std::vector<std::string> names;
    for (const PassTime& pass : frame.passes) names.push_back(pass.name);
    return names;
}

// The hashes of the buffers that were asked for.
std::map<std::string, std::string> hashes_of(const Frame& frame, const WantedBuffers& wanted) {
    std::map<std::string, std::string> hashes;
    const auto add = [&](const char* name, const auto& buffer) {
        if (wanted.contains(name)) hashes[name] = content_hash(buffer);
    };
    add("normal", frame.gbuffer.normal);
    add("view_depth", frame.gbuffer.view_depth);
    add("ndc_depth", ndc_depth(frame.gbuffer.depth));
    add("ao_raw", frame.ao_raw);
    add("ao_blurred", frame.ao_blurred);
    add("lit", frame.lit);
    return hashes;
}

void everything_open(const Scene& scene) {
    for (const char* method : {"xjun", "luna", "none"}) {
        for (const bool keep_all : {false, true}) {
            FrameRequest request = request_for(method, {37, 23});
            request.run.kept = keep_all ? KeptWork::all() : KeptWork();
            CAPTURE(std::string(method));
            CAPTURE(keep_all);
            const Frame frame = render_frame(scene, scene.camera, request);
            REQUIRE(frame.ao_raw.size == Size{19, 12});
            REQUIRE(frame.ao_blurred.size == Size{19, 12});
            CHECK(other_than(frame.ao_raw, 1) == "");
            CHECK(other_than(frame.ao_blurred, 1) == "");
            CHECK(other_than(frame.gbuffer.view_depth, kInfinity) == "");
            CHECK(other_than(ndc_depth(frame.gbuffer.depth), 1) == "");
            CHECK(content_hash(frame.gbuffer.normal) == content_hash(Image3({37, 23}, glm::vec3(0))));
            CHECK(content_hash(frame.lit) == content_hash(Image3({37, 23}, scene.sky)));
        }
    }
}

}  // namespace

TEST_CASE("frame: nothing to see is exactly open, raw and blurred") {
    SUBCASE("no triangles") { everything_open(empty_scene()); }
    SUBCASE("all behind the eye") { everything_open(scene_of({facing_quad({0, 0, -5}, 2)})); }
    SUBCASE("all culled") {
        Mesh away = facing_quad({0, 0, 5}, 2);
        for (auto& triangle : away.triangles) std::swap(triangle[1], triangle[2]);
        everything_open(scene_of({away}));
    }
    SUBCASE("a camera that looks at the sky") {
        Scene scene = still_life();
        scene.camera.target = {0, 1, 0.1};
        everything_open(scene);
    }
}

TEST_CASE("frame: passes in their order, the frame last, each once a repeat") {
    const Scene scene = still_life();
    FrameRequest request = request_for("xjun", {32, 24});
    request.repeats = 3;
    const Frame frame = render_frame(scene, scene.camera, request);
    CHECK(pass_names(frame) == std::vector<std::string>{"normal_depth", "ao", "blur", "lit", "frame"});
    for (const PassTime& pass : frame.passes) {
        CAPTURE(pass.name);
        CHECK(pass.runs == 3);
        CHECK(pass.wall_ms > 0);
        CHECK(pass.cpu_ms >= 0);
        CHECK(pass.wall_ms_mad >= 0);
        // In every repeat the frame takes longer than any of its passes, so its median does.
        CHECK(pass.wall_ms <= frame.passes.back().wall_ms);
    }
    request.repeats = 1;
    CHECK(hashes_of(render_frame(scene, scene.camera, request), all_buffers()) ==
          hashes_of(frame, all_buffers()));
}

TEST_CASE("frame: a pass that is left out does not run, and what it would make stays empty") {
    const Scene scene = still_life();
    struct Case {
        WantedBuffers wanted;
        std::vector<std::string> passes;
    };
    const Case cases[] = {
        {{"normal"}, {"normal_depth", "frame"}},
        {{"ao_raw"}, {"normal_depth", "ao", "frame"}},
        {{"ao_blurred"}, {"normal_depth", "ao", "blur", "frame"}},
        {{"lit"}, {"normal_depth", "ao", "blur", "lit", "frame"}},
    };
    for (const Case& expected : cases) {
        CAPTURE(*expected.wanted.begin());
        FrameRequest request = request_for("luna", {32, 24});
        request.wanted = expected.wanted;
        const Frame frame = render_frame(scene, scene.camera, request);
        CHECK(pass_names(frame) == expected.passes);
        const auto ran = [&](const char* pass) {
            return std::find(expected.passes.begin(), expected.passes.end(), pass) != expected.passes.end();
        };
        CHECK(frame.ao_raw.empty() != ran("ao"));
        CHECK(frame.ao_blurred.empty() != ran("blur"));
        CHECK(frame.lit.empty() != ran("lit"));
        request.run.kept = KeptWork::all();
        CHECK(pass_names(render_frame(scene, scene.camera, request)).size() == 5);
    }
    CHECK(pass_names(render_frame(empty_scene(), scene.camera, request_for("xjun", {32, 24}))) ==
          std::vector<std::string>{"normal_depth", "lit", "frame"});
}

TEST_CASE("frame: whichever buffers are asked for, each has the bits it has among all of them") {
    const Scene with = still_life(), without = empty_scene();
    for (const Scene* scene : {&with, &without}) {
        for (const char* method : {"xjun", "luna", "none"}) {
            for (const int iterations : {0, 2}) {
                FrameRequest request = request_for(method, {29, 21});
                request.settings.method =
                    with_value(*request.method, request.settings.method, "blur_iterations", iterations);
                const auto all = hashes_of(render_frame(*scene, scene->camera, request), all_buffers());
                for (unsigned bits = 0; bits < 64; ++bits) {
                    request.wanted.clear();
                    std::map<std::string, std::string> expected;
                    for (unsigned i = 0; i < 6; ++i) {
                        if ((bits >> i & 1) == 0) continue;
                        request.wanted.insert(kBufferNames[i]);
                        expected[kBufferNames[i]] = all.at(kBufferNames[i]);
                    }
                    CAPTURE(scene->name);
                    CAPTURE(std::string(method));
                    CAPTURE(iterations);
                    CAPTURE(bits);
                    CHECK(hashes_of(render_frame(*scene, scene->camera, request), request.wanted) ==
                          expected);
                }
            }
        }
    }
}

TEST_CASE("frame: sizes of the AO maps") {
    const Scene scene = scene_of({facing_quad({0, 0, 4}, 1)});
    const std::pair<Size, Size> sizes[] = {
        {{801, 601}, {401, 301}}, {{1, 1}, {1, 1}}, {{32767, 1}, {16384, 1}}, {{2, 7}, {1, 4}}};
    for (const auto& sides : sizes) {
        const Size picture = sides.first, half = sides.second;
        CAPTURE(picture.width);
        FrameRequest request = request_for("xjun", picture);
        request.wanted = {"ao_blurred"};
        CHECK(render_frame(scene, scene.camera, request).ao_blurred.size == half);
        if (picture.width > 1000) continue;
        ao_of(request.settings).ao_scale = 1;
        CHECK(render_frame(scene, scene.camera, request).ao_blurred.size == picture);
    }
}

TEST_CASE("frame: every stored format and depth direction gives finite AO near that of float32") {
    const Scene scene = still_life();
    const auto mean_with = [&](const char* method, const std::vector<std::string>& assignments) {
        FrameRequest request = request_for(method, {64, 48});
        request.settings = settings_of(*request.method, assignments);
        const Frame frame = render_frame(scene, scene.camera, request);
        CHECK(frame.camera.reversed_z == request.settings.reversed_z);
        CHECK(outside_unit_interval(frame.ao_blurred) == "");
        return buffer_statistics(frame.ao_blurred).mean;
    };
    for (const char* method : {"xjun", "luna"}) {
        const double mean = mean_with(method, {});
        CHECK(mean < 0.98);
        for (const char* assignment :
             {"depth_format=d24", "depth_format=d32f_reversed", "buffer_format=float16",
              "buffer_format=float16_nearest", "ao_format=float16", "ao_format=float16_nearest"}) {
            CAPTURE(std::string(method));
            CAPTURE(std::string(assignment));
            CHECK(std::fabs(mean_with(method, {assignment}) - mean) < 0.005);
        }
    }
}

TEST_CASE("frame: with a history every method's second frame is the mean of two seeds, at rest") {
    const Scene scene = still_life();
    for (const Method& method : ao_methods()) {
        if (!method.computes_ao()) continue;
        CAPTURE(std::string(method.name));
        FrameRequest request = request_for(method.name, {48, 32});
        request.wanted = {"ao_raw"};
        const auto map_of = [&](double seed, int longest, const AoHistory& last) {
            FrameRequest seeded = request;
            seeded.settings.method = with_value(method, request.settings.method, "seed", seed);
            seeded.settings.history.longest = longest;
            return render_frame(scene, scene.camera, seeded, last);
        };
        const Image<float> first = map_of(1, 1, {}).ao_raw, second = map_of(2, 1, {}).ao_raw;
        const Frame before = map_of(1, 2, {}), after = map_of(2, 2, before.history);
        CHECK(content_hash(before.ao_raw) == content_hash(first));
        CHECK(content_hash(after.history.ao) == content_hash(after.ao_raw));
        CHECK(pixels_against(first.size, [&](int x, int y) {
                  const float mean = 0.5f * (first.at(x, y) + second.at(x, y));
                  return std::fabs(after.ao_raw.at(x, y) - mean) < 1e-6f;
              }) == "");
        CHECK(map_of(2, 1, before.history).history.empty());  // nothing is kept that nobody asked for
    }
}
