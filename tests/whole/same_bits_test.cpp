// How a frame is computed never changes a bit of it: lanes, instruction sets, threads, tiles, repeats,
// leaving out. The goldens hold the same between compilers and build types.
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "chapters/frame/frame.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/every_run.h"
#include "tests/tools/noise.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"
#include "tests/tools/tutorial_settings.h"

using namespace crevice;

namespace {

// Sanitizers and -O0 slow a frame down about fifteen times; the largest size then runs in fewer combinations.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
constexpr bool kSlowBuild = true;
#else
constexpr bool kSlowBuild = false;
#endif

FrameRequest request_for(const std::string& method, Size size,
                         const std::vector<std::string>& assignments = {}) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method(method);
    request.settings = settings_of(*request.method, assignments);
    return request;
}

// All six buffers, as one text: a failure shows which of them differ.
std::string hashes_of(const Scene& scene, const FrameRequest& request) {
    const Frame frame = render_frame(scene, scene.camera, request);
    return "normal " + content_hash(frame.gbuffer.normal) + " view_depth " +
           content_hash(frame.gbuffer.view_depth) + " ndc_depth " +
           content_hash(ndc_depth(frame.gbuffer.depth, request.run)) + " ao_raw " +
           content_hash(frame.ao_raw) + " ao_blurred " + content_hash(frame.ao_blurred) + " lit " +
           content_hash(frame.lit);
}

std::string plain_hashes(const Scene& scene, FrameRequest request) {
    request.run = kOneLane;
    return hashes_of(scene, request);
}

// A texture, back faces, clipping at the near plane and the tutorials' other lighting model in one scene.
Scene odds_and_ends() {
    Scene scene = still_life();
    Image3 texels({6, 5}, glm::vec3(0));
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 6; ++x) texels.set(x, y, {noise(71, x, y), noise(72, x, y), noise(73, x, y)});
    }
    scene.materials.emplace_back().texture = std::make_shared<const Texture>(build_texture(texels));
    scene.meshes[0].parts[0].material = scene.meshes[2].parts[0].material = 1;
    scene.two_sided = true;
    scene.lighting = LightingModel::phong;
    scene.lights[1] = {glm::normalize(glm::vec3(1, -2, 1)), glm::vec3(0.2f), glm::vec3(0.5f),
                       glm::vec3(0.4f)};
    return scene;
}

}  // namespace

TEST_CASE("same bits: lanes x instruction sets x threads x tiles, odd sizes, both methods") {
    const RunChoices many{.threads = {1, 2, 7}, .tile_sizes = {16, 32, 64}},
        few{.threads = {7}, .tile_sizes = {32, 64}};
    for (const Scene& scene : {columns_scene(), columns_luna_scene(), cornell_scene()}) {
        for (const char* method : {"xjun", "luna"}) {
            for (const Size size : {Size{37, 23}, {1, 1}, {161, 91}}) {
                FrameRequest request = request_for(method, size);
                const std::string plain = plain_hashes(scene, request);
                CAPTURE(scene.name);
                CAPTURE(std::string(method));
                CAPTURE(size.width);
                for_every_run(kSlowBuild && size.width > 37 ? few : many, [&](const Run& run) {
                    request.run = run;
                    CHECK(hashes_of(scene, request) == plain);
                });
            }
        }
    }
}

TEST_CASE("same bits: every format, projection, texture and the published text") {
    const std::vector<std::string> variants[] = {
        {},
        {"as_published=true"},
        {"buffer_format=float16", "ao_format=float16", "as_published=true"},
        {"buffer_format=float16_nearest", "ao_format=float16_nearest", "as_published=true"},
        {"buffer_format=float16_nearest"},
        {"depth_format=d16"},
        {"depth_format=d24"},
        {"depth_format=d32f_reversed"},
        {"samples=1", "exponent=0.3", "fade_end=0.2"},
        {"blur_iterations=1", "blur_weights=luna", "blur_normal=0.2", "blur_depth=1"},
        {"random_vectors=raw", "sign_of_zero=zero", "border=wrap", "blur_edges=slope"},
        {"random_vectors=none", "self_occlusion_test=false", "border=edge", "blur_edges=none"},
        {"depth_source=view_depth", "edge_texels=mixed", "sky_depth=as_stored"},
        {"depth_source=ndc_depth", "texel_centre=off", "buffer_format=float16_nearest"},
    };
    Scene scene = odds_and_ends();
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        scene.camera.projection = projection;
        scene.camera.ortho_height = 4;
        for (const char* method : {"xjun", "luna"}) {
            for (const auto& variant : variants) {
                for (const float ao_scale : {0.5f, 1.0f}) {
                    FrameRequest request = request_for(method, {43, 31}, variant);
                    ao_of(request.settings).ao_scale = ao_scale;
                    const std::string plain = plain_hashes(scene, request);
                    CAPTURE(static_cast<int>(projection));
                    CAPTURE(std::string(method));
                    CAPTURE(&variant - variants);
                    CAPTURE(ao_scale);
                    for_every_run({.tile_sizes = {16}}, [&](const Run& run) {
                        request.run = run;
                        CHECK(hashes_of(scene, request) == plain);
                    });
                }
            }
        }
    }
}

TEST_CASE("same bits: a hundred times, also after another scene in another size") {
    const Scene scene = columns_scene(), other = odds_and_ends();
    for (const char* method : {"xjun", "luna"}) {
        FrameRequest request = request_for(method, {37, 23});
        request.run.threads = 2;
        const std::string first = hashes_of(scene, request);
        const FrameRequest in_between = request_for("luna", {64, 9}, {"as_published=true"});
        const std::string first_other = hashes_of(other, in_between);
        int unlike = 0;
        for (int i = 0; i < 100; ++i) {
            unlike += hashes_of(scene, request) != first;
            if (i % 10 == 0) unlike += hashes_of(other, in_between) != first_other;
        }
        CAPTURE(std::string(method));
        CHECK(unlike == 0);
        CHECK(first != first_other);
    }
}

TEST_CASE("same bits: with --keep-all and without, in every built-in scene") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const Scene scene = builtin.make();
        for (const char* method : {"xjun", "luna", "none"}) {
            for (const int iterations : {0, 3}) {
                CAPTURE(scene.name);
                CAPTURE(std::string(method));
                CAPTURE(iterations);
                FrameRequest request = request_for(method, {41, 27});
                request.settings.method =
                    with_value(*request.method, request.settings.method, "blur_iterations", iterations);
                const std::string without = hashes_of(scene, request);
                request.run.kept = KeptWork::all();
                CHECK(hashes_of(scene, request) == without);
            }
        }
    }
}

TEST_CASE("same bits: depths beyond the largest half keep unit normals") {
    // From 65520 on a half rounds to infinity, which is the background's view depth.
    Mesh wall = quad_mesh({glm::vec3(-50000, 30000, 65000),
                           {50000, 30000, 66000},
                           {50000, -30000, 66000},
                           {-50000, -30000, 65000}},
                          {0, 0, -1});
    wall.normals = {{-0.6f, 0, -0.8f}, {0.6f, 0, -0.8f}, {0.6f, 0, -0.8f}, {-0.6f, 0, -0.8f}};
    Scene scene = scene_of({wall});
    scene.camera.near_plane = 100;
    scene.camera.far_plane = 100000;
    const NormalDepthSettings settings{.buffer_format = BufferFormat::float16_nearest_even};
    const Size size = {161, 91};
    const GBuffer eight = normal_depth(scene, scene.camera, size, settings, {.lanes = 0});
    const GBuffer one = normal_depth(scene, scene.camera, size, settings, {.lanes = 1});
    CHECK(content_hash(eight.normal) == content_hash(one.normal));
    const std::int32_t cleared = cleared_depth(size, DepthFormat::d32f, false).codes.at(0, 0);
    int drawn = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (eight.depth.codes.at(x, y) == cleared) continue;
            ++drawn;
            CAPTURE(x);
            CAPTURE(y);
            CHECK(std::fabs(glm::length(glm::dvec3(eight.normal.at(x, y))) - 1) < 1e-3);
        }
    }
    CHECK(drawn > 5000);
}
