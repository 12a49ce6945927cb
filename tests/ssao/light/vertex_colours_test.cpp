// Vertex colours in the lit picture.
#include "rasterizer/draw/vertex_colours.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/image_summary.h"
#include "ssao/light/shade.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

constexpr Size kSize{48, 27};

// A square seen from the front under ambient light of 1 alone, so that the picture shows its colours.
Scene plainly_lit(Mesh square) {
    Scene scene = scene_of({std::move(square)});
    scene.sky = glm::vec3(0);
    scene.two_sided = true;
    scene.camera.near_plane = 0.5;
    scene.lighting = LightingModel::blinn_schlick;
    scene.ambient_light = glm::vec3(1);
    scene.lights = {};
    scene.materials[0].diffuse = glm::vec3(0.5f);
    return scene;
}

Image3 lit(const Scene& scene, const Run& run = {}) {
    return shade(scene, scene.camera, normal_depth(scene, scene.camera, kSize, {}, run).depth, {},
                 ShadeSettings{}, run);
}

}  // namespace

TEST_CASE("vertex colours: linear across a surface, whatever its depth, times the material's") {
    Mesh square = facing_quad({0, 0, 4}, 1);
    for (const glm::vec3& p : square.positions)
        square.colours.emplace_back(0.5f + 0.5f * p.x, 0.5f + 0.5f * p.y, 0.25f);
    for (glm::vec3& p : square.positions) p.z += p.x;  // now one side is nearer
    const Scene scene = plainly_lit(square);
    const Image3 picture = lit(scene);
    const GBuffer g = normal_depth(scene, scene.camera, kSize);
    const CameraMatrices matrices = camera_matrices(scene.camera, kSize);
    int seen = 0;
    CHECK(pixels_against(kSize, [&](int x, int y) {
              const float z = g.view_depth.at(x, y);
              if (!std::isfinite(z)) return picture.at(x, y) == glm::vec3(0);
              ++seen;
              // Camera axes are the world's; the eye looks along z.
              const float u = (static_cast<float>(x) + 0.5f) / kSize.width,
                          v = (static_cast<float>(y) + 0.5f) / kSize.height;
              const glm::vec3 p((2 * u - 1) * matrices.ray_scale.x * z,
                                (1 - 2 * v) * matrices.ray_scale.y * z, z);
              const glm::vec3 world = p + glm::vec3(scene.camera.eye);
              const glm::vec3 wanted = 0.5f * glm::vec3(0.5f + 0.5f * world.x, 0.5f + 0.5f * world.y, 0.25f);
              return glm::length(picture.at(x, y) - wanted) < 1e-4f;
          }) == "");
    CHECK(seen > 20);
}

TEST_CASE("vertex colours: white ones change no bit, and every run gives the same") {
    const Mesh plain = facing_quad({0, 0, 4}, 1);
    Mesh white = plain, varied = plain;
    for (std::size_t i = 0; i < plain.positions.size(); ++i) {
        white.colours.emplace_back(1);
        varied.colours.emplace_back(0.1f * static_cast<float>(i), 0.7f, 1.0f / static_cast<float>(i + 1));
    }
    CHECK(content_hash(lit(plainly_lit(white))) == content_hash(lit(plainly_lit(plain))));
    CHECK_FALSE(has_vertex_colours(plainly_lit(plain)));
    const Scene scene = plainly_lit(varied);
    const std::string hash = content_hash(lit(scene, kOneLane));
    for_every_run({.threads = {1, 3}, .tile_sizes = {16, 64}}, [&](Run run) {
        CHECK(content_hash(lit(scene, run)) == hash);
        run.kept = KeptWork::all();
        CHECK(content_hash(lit(scene, run)) == hash);
    });
}
