#include "ssao/rays/depth_mesh.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "ssao/rays/ray_cast_ao.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize{64, 36};

RayAoSettings settings_with(float radius) {
    RayAoSettings settings;
    settings.rays = 256;
    settings.radius = radius;
    return settings;
}

// Accessibility of a view's pixels by rays against its depth buffer.
Image<float> screen_ao(const Scene& scene, const RayAoSettings& settings, const Run& run = {}) {
    const GBuffer g = normal_depth(scene, scene.camera, kSize, run);
    const SurfacePoints points =
        points_on_depth_mesh(surface_points(scene, scene.camera, g, run), g, scene.camera, run);
    const RayScene rays = depth_mesh(g, scene.camera, settings.radius, run);
    return picture_of(points, ray_cast_ao(rays, points.points, settings, run));
}

Scene floor_scene(float slope) {
    Scene scene = scene_of({quad_mesh({glm::vec3(-900, -1 + 900 * slope, 900),
                                       {900, -1 + 900 * slope, 900},
                                       {900, -1 - 900 * slope, -900},
                                       {-900, -1 - 900 * slope, -900}},
                                      glm::normalize(glm::vec3(0, 1, -slope)))});
    scene.camera.near_plane = 0.5;
    return scene;
}

}  // namespace

TEST_CASE("depth mesh: planes, seen however slanted, are open exactly") {
    for (const float slope : {0.0f, 0.01f, 0.5f, 2.0f}) {
        for (const float radius : {0.5f, 20.0f, kInfinity}) {
            CAPTURE(slope);
            CAPTURE(radius);
            const Image<float> ao = screen_ao(floor_scene(slope), settings_with(radius));
            for (int y = 0; y < kSize.height; ++y) {
                for (int x = 0; x < kSize.width; ++x) {
                    CAPTURE(x);
                    CAPTURE(y);
                    REQUIRE(ao.at(x, y) == 1);
                }
            }
        }
    }
}

TEST_CASE("depth mesh: in an open corner, all of it in view, the depth buffer knows as much as the scene") {
    // A floor and a wall that meet at z = 4, seen from above and in front.
    Scene scene =
        scene_of({quad_mesh({glm::vec3(-9, -1, 4), {9, -1, 4}, {9, -1, -9}, {-9, -1, -9}}, {0, 1, 0}),
                  quad_mesh({glm::vec3(-9, 9, 4), {9, 9, 4}, {9, -1, 4}, {-9, -1, 4}}, {0, 0, -1})});
    scene.camera.near_plane = 0.25;
    const RayAoSettings settings = settings_with(0.75f);
    const Image<float> screen = screen_ao(scene, settings);
    const GBuffer g = normal_depth(scene, scene.camera, kSize);
    const SurfacePoints points = surface_points(scene, scene.camera, g);
    const std::vector<float> truth = ray_cast_ao(ray_scene(scene, scene.camera.eye), points.points, settings);
    double difference = 0, closed = 0;
    int counted = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const int x = points.pixel[i] % kSize.width, y = points.pixel[i] / kSize.width;
        if (x < 12 || x >= 52) continue;  // beyond the picture's sides nothing is known
        CAPTURE(x);
        CAPTURE(y);
        // Between two rows of pixels the mesh cuts the corner off.
        CHECK(std::abs(screen.at(x, y) - truth[i]) < 0.12f);
        difference += static_cast<double>(screen.at(x, y) - truth[i]);
        closed += 1 - static_cast<double>(truth[i]);
        ++counted;
    }
    REQUIRE(counted > 1000);
    CHECK(closed / counted > 0.02);
    CHECK(std::abs(difference) / counted < 0.1 * closed / counted);
}

TEST_CASE("depth mesh: surfaces further apart than `join` are not joined, the background never is") {
    // A square in front of the middle of a wall that covers the view.
    Scene scene = scene_of({facing_quad({0, 0, 6}, 20), facing_quad({0, 0, 4}, 1)});
    const GBuffer g = normal_depth(scene, scene.camera, kSize);
    const std::size_t quads = static_cast<std::size_t>((kSize.width - 1) * (kSize.height - 1));
    CHECK(depth_mesh(g, scene.camera, 3).triangles.size() == 2 * quads);
    CHECK(depth_mesh(g, scene.camera, kInfinity).triangles.size() == 2 * quads);
    int apart = 0;  // triangles with corners on both
    for (int y = 0; y + 1 < kSize.height; ++y) {
        for (int x = 0; x + 1 < kSize.width; ++x) {
            const bool a = g.view_depth.at(x, y) < 5, b = g.view_depth.at(x + 1, y) < 5,
                       c = g.view_depth.at(x, y + 1) < 5, d = g.view_depth.at(x + 1, y + 1) < 5;
            apart += (a != b || b != c) + (b != d || d != c);
        }
    }
    REQUIRE(apart > 20);
    CHECK(depth_mesh(g, scene.camera, 1).triangles.size() == 2 * quads - static_cast<std::size_t>(apart));

    scene = scene_of({facing_quad({0, 0, 4}, 1)});
    const GBuffer alone = normal_depth(scene, scene.camera, kSize);
    int pixels = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) pixels += alone.view_depth.at(x, y) < kInfinity ? 1 : 0;
    }
    const double side = std::sqrt(static_cast<double>(pixels));
    CHECK(depth_mesh(alone, scene.camera, kInfinity).triangles.size() ==
          static_cast<std::size_t>(2 * (side - 1) * (side - 1)));
}

TEST_CASE("depth mesh: corners are the positions that the pixels show; nothing in view gives an empty tree") {
    Scene scene = still_life();
    const GBuffer g = normal_depth(scene, scene.camera, kSize);
    const SurfacePoints points =
        points_on_depth_mesh(surface_points(scene, scene.camera, g), g, scene.camera);
    std::vector<glm::vec3> position(static_cast<std::size_t>(kSize.width * kSize.height));
    for (std::size_t i = 0; i < points.pixel.size(); ++i)
        position[static_cast<std::size_t>(points.pixel[i])] = points.points[i].position;
    const RayScene mesh = depth_mesh(g, scene.camera, 1);
    REQUIRE(!mesh.triangles.empty());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const int upper = mesh.sources[i].triangle / 2;
        const bool second = mesh.sources[i].triangle % 2 == 1;
        const int corner = second ? upper + 1 : upper;
        CAPTURE(i);
        CHECK(mesh.triangles[i][0] == position[static_cast<std::size_t>(corner)]);
    }
    scene.camera.target = {0, 1, 0};
    scene.camera.up = {0, 0, 1};
    const GBuffer sky = normal_depth(scene, scene.camera, kSize);
    CHECK(depth_mesh(sky, scene.camera, 1).bvh.nodes.empty());
}

TEST_CASE("depth mesh: the same bits at every thread and lane count; a join that is no length is refused") {
    const Scene scene = still_life();
    const RayAoSettings settings = settings_with(1);
    const Image<float> ao = screen_ao(scene, settings);
    for (const int threads : {1, 7}) {
        Run run;
        run.threads = threads;
        run.lanes = threads == 1 ? 1 : 0;
        CHECK(screen_ao(scene, settings, run).pixels == ao.pixels);
    }
    const GBuffer g = normal_depth(scene, scene.camera, kSize);
    for (const float join : {0.0f, -1.0f, kNan})
        CHECK_THROWS_AS(depth_mesh(g, scene.camera, join), UsageError);
}
