// The vertex bake as an AO map.
#include "ssao/bakes/vertex_bake.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "rasterizer/draw/normal_depth.h"
#include "ssao/ao_methods.h"
#include "ssao/bakes/vertex_ao_picture.h"
#include "ssao/inputs/pixel_fetch.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize = {53, 31};

struct BakedStillLife {
    Scene scene = still_life();
    GBuffer gbuffer = normal_depth(scene, scene.camera, kSize);
    RayScene rays = ray_scene(scene, scene.camera.eye);

    AoInputs inputs(const VertexBakeSettings& settings = {}) const {
        return ao_inputs(gbuffer, scene.camera, pixel_fetch(settings));
    }
    AoMap map(const VertexBakeSettings& settings = {}) const {
        return vertex_bake(scene, scene.camera, rays, inputs(settings), baked_vertices(scene, rays, settings),
                           settings);
    }
};

}  // namespace

TEST_CASE("vertex bake: the picture of the baked vertices where a surface is, open where none is") {
    const BakedStillLife s;
    const VertexBakeSettings settings{.samples = 16, .exponent = 2};
    const VertexAo baked = baked_vertices(s.scene, s.rays, settings);
    const Image<float> picture = vertex_ao_picture(s.scene, s.scene.camera, kSize, s.rays, baked);
    const Image<float> map = s.map(settings).ao;
    CHECK(pixels_against(kSize, [&](int x, int y) {
              if (!(s.gbuffer.view_depth.at(x, y) < kInfinity)) return map.at(x, y) == 1;
              const float open = picture.at(x, y);
              return std::fabs(map.at(x, y) - open * open) < 1e-5f;
          }) == "");
}

TEST_CASE("vertex bake: a bake that is given is shown, none is made") {
    const BakedStillLife s;
    const Method& method = find_method("vertex_bake");
    VertexAo half_open = baked_vertices(s.scene, s.rays, {.samples = 1});
    for (std::vector<float>& of_instance : half_open.accessibility)
        std::fill(of_instance.begin(), of_instance.end(), 0.25f);
    const AoView view{s.scene, s.scene.camera, s.gbuffer, &s.rays, &half_open};
    const Image<float> given = method.ao(view, method.defaults, {}).ao;
    CHECK(pixels_against(kSize, [&](int x, int y) {
              return given.at(x, y) == (s.gbuffer.view_depth.at(x, y) < kInfinity ? 0.25f : 1.0f);
          }) == "");
    const auto own = method.bake(s.scene, s.rays, method.defaults, {});
    CHECK(content_hash(
              method.ao({s.scene, s.scene.camera, s.gbuffer, &s.rays, own.get()}, method.defaults, {}).ao) ==
          content_hash(method.ao({s.scene, s.scene.camera, s.gbuffer, &s.rays}, method.defaults, {}).ao));
}

TEST_CASE("vertex bake: half of the hemisphere is closed at the foot of an endless wall, none far from it") {
    // A floor of four rows of vertices: at the wall, at 1/4, at 1 and at 8 radii.
    const float z[] = {6, 5.75f, 5, -2};
    std::vector<Mesh> meshes = {
        quad_mesh({glm::vec3(-50, 50, 6), {50, 50, 6}, {50, -1, 6}, {-50, -1, 6}}, {0, 0, -1})};
    for (int i = 0; i < 3; ++i)
        meshes.push_back(quad_mesh(
            {glm::vec3(-50, -1, z[i]), {50, -1, z[i]}, {50, -1, z[i + 1]}, {-50, -1, z[i + 1]}}, {0, 1, 0}));
    const Scene scene = scene_of(meshes);
    const RayScene rays = ray_scene(scene, scene.camera.eye);
    const VertexAo baked = baked_vertices(scene, rays, {.samples = 4096, .radius = 1});
    // Corners are cast from a little inside their triangles (kInward).
    const auto at = [&](std::size_t strip, std::size_t vertex) {
        return baked.accessibility[strip + 1][vertex];
    };
    CHECK(std::fabs(at(0, 0) - 0.5f) < 0.02f);
    CHECK(at(0, 2) > 0.6f);
    CHECK(at(2, 0) > 0.97f);
    CHECK(at(2, 2) == 1);
}

TEST_CASE("vertex bake: what is out of range is refused by name") {
    CHECK_THROWS_WITH_AS(validate(VertexBakeSettings{.samples = 0}), doctest::Contains("samples"),
                         UsageError);
    CHECK_THROWS_WITH_AS(validate(VertexBakeSettings{.radius = -1}), doctest::Contains("radius"), UsageError);
    CHECK_THROWS_WITH_AS(validate(VertexBakeSettings{.ao_scale = 0.3f}), doctest::Contains("ao_scale"),
                         UsageError);
}
