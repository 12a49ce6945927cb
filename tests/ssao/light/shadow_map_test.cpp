// The shadow map: where the light stands, the codes it stores, its bias, and that neither position nor scale
// matters.
#include "ssao/light/shadow_map.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "ssao/light/shadow_factor.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// Each corner's y is slope * x: level, or tilted about z. Seen from above.
Scene roof(float slope) {
    const auto at = [&](float x, float z) { return glm::vec3(x, slope * x, z); };
    const glm::vec3 normal = glm::normalize(glm::vec3(-slope, 1, 0));
    return scene_of({quad_mesh({at(-30, 30), at(30, 30), at(30, -30), at(-30, -30)}, normal)});
}

const glm::vec3 kDown(0, -1, 0);

Image<std::int32_t> codes_of(const Scene& scene, const ShadowSettings& settings) {
    return shadow_map(scene, kDown, xjun_shadow_fit(), settings).depth.codes;
}

}  // namespace

TEST_CASE("shadow map: the light stands where the tutorials put it") {
    const glm::vec3 direction(0.577f, -0.577f, 0.577f);
    const glm::dvec3 unit = glm::normalize(glm::dvec3(direction));
    const Camera luna = light_camera(sphere_shadow_fit({1, 2, 3}, kLunaShadowRadius), direction);
    CHECK(kLunaShadowRadius == std::sqrt(10.0 * 10 + 15 * 15));
    CHECK(glm::length(luna.eye - (glm::dvec3(1, 2, 3) - 2 * kLunaShadowRadius * unit)) < 1e-5);
    CHECK(luna.target == glm::dvec3(1, 2, 3));
    CHECK(luna.ortho_height == 2 * kLunaShadowRadius);
    CHECK(luna.near_plane == kLunaShadowRadius);
    CHECK(luna.far_plane == 3 * kLunaShadowRadius);
    const Camera xjun = light_camera(xjun_shadow_fit(), direction);
    CHECK(glm::length(xjun.eye + 40.0 * unit) < 1e-5);
    CHECK(xjun.ortho_height == 40);
    CHECK(xjun.near_plane == 20);
    CHECK(xjun.far_plane == 60);
    CHECK(xjun.up == glm::dvec3(0, 1, 0));
    CHECK(xjun.projection == Projection::orthographic);
}

TEST_CASE("shadow map: the sphere around a box sees all of it from everywhere") {
    const Scene scene = still_life();
    const Bounds bounds = world_bounds(scene);
    RandomSequence random(4);
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 direction(random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1));
        const ScreenGeometry geometry =
            shadow_geometry(scene, light_camera(bounds_shadow_fit(bounds), direction), {.size_px = 64});
        CAPTURE(i);
        for (const std::int32_t outside : geometry.vertices.projected.outside) CHECK(outside == 0);
    }
    CHECK(bounds_shadow_fit(Bounds{}).half_width == 1);
}

TEST_CASE("shadow map: a light straight up or down has an up of its own") {
    for (const glm::vec3 direction :
         {glm::vec3(0, -1, 0), {0, 2, 0}, {0.004f, -1, 0}, {1e-30f, -1e-20f, 0}}) {
        CAPTURE(direction.x);
        CAPTURE(direction.y);
        const Camera camera = light_camera(xjun_shadow_fit(), direction);
        CHECK(camera.up == glm::dvec3(0, 0, 1));
    }
    CHECK(light_camera(xjun_shadow_fit(), {0.006f, -1, 0}).up == glm::dvec3(0, 1, 0));
}

TEST_CASE("shadow map: D24 codes are exact, bias and all") {
    // Half way between near and far; the light looks straight down on it.
    const Scene level = roof(0);
    const ShadowSettings plain{.size_px = 64, .bias = {}};
    CHECK(differences(codes_of(level, plain), 8388608) == "");
    ShadowSettings biased = plain;
    biased.bias = {100000, 1.0f};  // a level plane has no slope
    CHECK(differences(codes_of(level, biased), 8388608 + 100000) == "");
    biased.bias = {-100000, 0};
    CHECK(differences(codes_of(level, biased), 8388608 - 100000) == "");
    biased.format = DepthFormat::d16;
    biased.bias = {100, 0};
    CHECK(differences(codes_of(level, biased), 32768 + 100) == "");

    // 40 units over 64 texels and over the depth: 1 unit a unit is 1/64 ndc a texel.
    const Scene tilted = roof(0.5f);
    ShadowSettings slope = plain;
    slope.bias = {0, 2.0f};
    const Image<std::int32_t> without = codes_of(tilted, plain), with = codes_of(tilted, slope);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            CHECK(std::abs(with.at(x, y) - without.at(x, y) - 262144) <= 1);
        }
    }
}

TEST_CASE("shadow map: nothing is depth 1, and back faces cast when asked") {
    const std::int32_t clear = depth_code(DepthFormat::d24, 1.0f, 0.0);
    CHECK(differences(codes_of(scene_of({}), {.size_px = 33}), clear) == "");
    Scene from_below = roof(0);
    std::swap(from_below.meshes[0].triangles[0][0], from_below.meshes[0].triangles[0][1]);
    std::swap(from_below.meshes[0].triangles[1][0], from_below.meshes[0].triangles[1][1]);
    CHECK(differences(codes_of(from_below, {.size_px = 33}), clear) == "");
    CHECK(differences(codes_of(from_below, {.size_px = 33, .bias = {}, .cull_back_faces = false}), 8388608) ==
          "");
    from_below.two_sided = true;
    CHECK(differences(codes_of(from_below, {.size_px = 33, .bias = {}}), 8388608) == "");
}

TEST_CASE("shadow map: the same bits for all lanes, threads, tiles and instruction sets") {
    const Scene scene = still_life();
    const ShadowFit fit = bounds_shadow_fit(world_bounds(scene));
    const ShadowSettings settings{.size_px = 203};
    const auto codes = [&](const Run& run) {
        return shadow_map(scene, {0.4f, -0.8f, 0.3f}, fit, settings, run).depth.codes;
    };
    const Image<std::int32_t> plain = codes(kOneLane);
    for_every_run({.tile_sizes = {16, 128}},
                  [&](const Run& run) { CHECK(differences(codes(run), plain) == ""); });
    CHECK(differences(codes({.kept = KeptWork::all()}), plain) == "");
}

TEST_CASE("shadow map: a scene moved far away has the same map and the same look-ups") {
    const Scene scene = still_life();
    const glm::dvec3 shift(1073741824, -1073741824, 536870912);
    Scene moved = scene;
    for (Instance& instance : moved.instances) {
        instance.world_from_object[3] += glm::vec4(glm::vec3(shift), 0);
    }
    moved.camera.eye += shift;
    moved.camera.target += shift;
    const ShadowFit fit = sphere_shadow_fit({0, 0, 4}, 6),
                    moved_fit = sphere_shadow_fit(fit.centre + shift, 6);
    RandomSequence random(6);
    for (int i = 0; i < 12; ++i) {
        const glm::vec3 direction{random.between(0.1, 1), random.between(-1, -0.1), random.between(0.1, 1)};
        const ShadowMap map = shadow_map(scene, direction, fit, {.size_px = 96}),
                        moved_map = shadow_map(moved, direction, moved_fit, {.size_px = 96});
        CAPTURE(i);
        CHECK(differences(moved_map.depth.codes, map.depth.codes) == "");
        const ShadowLookup lookup = shadow_lookup(map, scene.camera),
                           moved_lookup = shadow_lookup(moved_map, moved.camera);
        CHECK(moved_lookup.column == lookup.column);
        CHECK(moved_lookup.row == lookup.row);
        CHECK(moved_lookup.depth == lookup.depth);
    }
}

TEST_CASE("shadow map: a scene in other units has the same map") {
    const Scene scene = still_life();
    const glm::vec3 direction(0.4f, -0.8f, 0.3f);
    const ShadowFit fit = sphere_shadow_fit({0, 0, 4}, 6);
    const ShadowMap map = shadow_map(scene, direction, fit, {.size_px = 128});
    const ShadowLookup lookup = shadow_lookup(map, scene.camera);
    for (const int k : {-10, 7}) {
        CAPTURE(k);
        const double factor = std::ldexp(1.0, k);
        const Scene larger = scaled(scene, k);
        const ShadowMap larger_map = shadow_map(
            larger, direction, sphere_shadow_fit(factor * fit.centre, factor * 6), {.size_px = 128});
        CHECK(differences(larger_map.depth.codes, map.depth.codes) == "");
        const ShadowLookup larger_lookup = shadow_lookup(larger_map, larger.camera);
        CHECK(larger_lookup.column.w == lookup.column.w);
        CHECK(larger_lookup.column.x * static_cast<float>(factor) == lookup.column.x);
    }
}

TEST_CASE("shadow map: settings and lights out of range are refused by name") {
    const auto refused = [](const ShadowSettings& settings) {
        CHECK_THROWS_AS(shadow_map(roof(0), kDown, xjun_shadow_fit(), settings), UsageError);
    };
    refused({.size_px = 0});
    refused({.size_px = kMaxShadowSide + 1});
    refused({.bias = {0, kNan}});
    refused({.shader_bias = kInfinity});
    refused({.comparison = DepthFunction::greater});
    for (const glm::vec3 direction : {glm::vec3(0), {kNan, 0, 1}, {0, kInfinity, 0}}) {
        CHECK_THROWS_AS(light_camera(xjun_shadow_fit(), direction), UsageError);
    }
    ShadowFit fit = xjun_shadow_fit();
    fit.half_width = 0;
    CHECK_THROWS_AS(light_camera(fit, kDown), UsageError);
    CHECK_THROWS_WITH(light_camera(sphere_shadow_fit({0, 0, 0}, -1), kDown),
                      "shadow map: the light's distance must be above 0 (-2); give another fit");
}
