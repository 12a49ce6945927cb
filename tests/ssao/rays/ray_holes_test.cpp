// Cut-outs as rays and reference points meet them.
#include "ssao/rays/ray_holes.h"

#include <memory>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/every_run.h"
#include "tests/tools/seen_ao.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

// Stripes along v a quarter of the texture wide, gaps of this alpha between them.
std::shared_ptr<const Texture> stripes(float gap) {
    const Size size{16, 16};
    Image<float> alpha(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) alpha.at(x, y) = x % 8 < 4 ? 1.0f : gap;
    }
    return std::make_shared<Texture>(build_texture(Image3(size, glm::vec3(0.5f)), alpha));
}

// A square fence, x and y from -1 to 1, at z = 3 before a wall at z = 4.
Scene fence(float gap, float cutoff = 0.1f) {
    Mesh bars = facing_quad({0, 0, 3}, 1), wall = facing_quad({0, 0, 4}, 20);
    bars.parts[0].material = 1;
    Scene scene = scene_of({bars, wall});
    scene.camera.near_plane = 0.5;
    scene.materials.emplace_back();
    scene.materials[1].texture = stripes(gap);
    scene.materials[1].sampler.filter = TextureFilter::point;
    scene.materials[1].alpha_cutoff = cutoff;
    return scene;
}

bool in_gap(double x) { return static_cast<int>(4 * (x + 1) / 2) % 2 == 1; }

}  // namespace

TEST_CASE("ray holes: a ray meets the bars, and the wall through the gaps") {
    const RayScene rays = ray_scene(fence(0), glm::dvec3(0));
    REQUIRE(rays.holes.any());
    int gaps = 0;
    for (int i = 0; i < 64; ++i) {
        const float x = -0.99f + 0.031f * static_cast<float>(i);
        const Ray ray{{x, 0.3f, 0}, {0, 0, 1}};
        CAPTURE(x);
        const bool gap = in_gap(static_cast<double>(x));
        gaps += gap ? 1 : 0;
        CHECK(closest_hit(rays, ray, 10).distance == (gap ? 4.0f : 3.0f));
        CHECK(occluded(rays, ray, 3.5f) == !gap);
        CHECK(occluded(rays, ray, 10));
    }
    CHECK(gaps > 25);
    Scene without_texcoords = fence(0);  // solid to the rasterizer, and so to rays
    without_texcoords.meshes[0].texcoords.clear();
    CHECK(
        closest_hit(ray_scene(without_texcoords, glm::dvec3(0)), {{0.7f, 0.3f, 0}, {0, 0, 1}}, 10).distance ==
        3);
    CHECK(normal_depth(without_texcoords, without_texcoords.camera, {33, 33}).view_depth.at(24, 16) < 3.5f);
    CHECK(!ray_scene(fence(0, 0), glm::dvec3(0)).holes.any());
}

TEST_CASE(
    "ray holes: all hole is as if nothing stood there, none as if it were solid; both ends of any number of "
    "lanes") {
    Scene bare = fence(0);
    bare.instances.erase(bare.instances.begin());
    Scene open = fence(0), solid = fence(1);
    open.materials[1].texture =
        std::make_shared<Texture>(build_texture(Image3({2, 2}, glm::vec3(0.5f)), Image<float>({2, 2}, 0.0f)));
    const RayAoSettings settings = few_rays(3, 128);
    const std::vector<float> expected = seen_ao(bare, settings).open;
    CHECK(seen_ao(open, settings).open == expected);
    CHECK(seen_ao(solid, settings).open == seen_ao(fence(1, 0), settings).open);

    const Scene half = fence(0);
    const GBuffer g = normal_depth(half, half.camera, {48, 32});
    const SurfacePoints points = surface_points(half, half.camera, g);
    const RayScene rays = ray_scene(half, half.camera.eye);
    const std::vector<float> ao = ray_cast_ao(rays, points.points, settings);
    double mean[2] = {0, 0};
    for (std::size_t i = 0; i < ao.size(); ++i) mean[0] += ao[i];
    for (const float v : seen_ao(solid, settings, {48, 32}).open) mean[1] += v;
    CHECK(mean[0] > mean[1]);
    for_every_run({.threads = {1, 3}},
                  [&](const Run& run) { CHECK(ray_cast_ao(rays, points.points, settings, run) == ao); });
}

TEST_CASE("ray holes: reference points lie where the picture shows them, on the bars and behind the gaps") {
    const Scene scene = fence(0);
    const Size size{96, 54};
    const GBuffer g = normal_depth(scene, scene.camera, size);
    const SurfacePoints points = surface_points(scene, scene.camera, g);
    int on_bars = 0, behind = 0;
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const int x = points.pixel[i] % size.width, y = points.pixel[i] / size.width;
        const float z = points.points[i].position.z;
        CHECK(std::abs(z - g.view_depth.at(x, y)) < 1e-5f);
        (z < 3.5f ? on_bars : behind) += 1;
    }
    CHECK(on_bars > 300);
    CHECK(behind > 1000);
}
