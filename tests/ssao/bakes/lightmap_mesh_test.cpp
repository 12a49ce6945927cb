#include <doctest/doctest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "ssao/bakes/lightmap_mesh.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

TEST_CASE("lightmap mesh: the triangles of the scene in the world, with their places in the map") {
    Scene scene = still_life();
    scene.instances.push_back({2, glm::scale(glm::translate(glm::mat4(1), glm::vec3(3, 2, 1)), {-1, 2, 1})});
    const RayScene rays = ray_scene(scene, {0, 0, 0});
    const LightmapCharts charts = lightmap_charts(scene, rays, {.texels = 128});
    const Mesh mesh = lightmap_mesh(scene, rays, charts);
    REQUIRE(mesh.triangles.size() == rays.triangles.size());
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    REQUIRE(mesh.texcoords.size() == mesh.positions.size());
    CHECK(mesh.positions.size() < 3 * mesh.triangles.size());
    CHECK(mesh.parts.size() == 1);
    CHECK(mesh.parts[0].triangle_count == mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const bool mirrored = rays.mirrored[static_cast<std::size_t>(rays.sources[i].instance)];
        CAPTURE(i);
        for (std::size_t k = 0; k < 3; ++k) {
            // Corners 1 and 2 change places in a mirror, so that fronts stay fronts.
            const std::size_t from = mirrored ? (3 - k) % 3 : k;
            const std::uint32_t vertex = mesh.triangles[i][k];
            CHECK(mesh.positions[vertex] == rays.triangles[i][from]);
            CHECK(mesh.texcoords[vertex] == charts.texcoords[i][from]);
        }
    }
}

TEST_CASE("lightmap mesh: triangles without area are left out") {
    Mesh quad = facing_quad({0, 0, 2}, 1);
    quad.triangles.insert(quad.triangles.begin(), {0, 0, 1});
    quad.parts[0].triangle_count = 3;
    const Scene scene = scene_of({quad});
    const RayScene rays = ray_scene(scene, {0, 0, 0});
    const Mesh mesh = lightmap_mesh(scene, rays, lightmap_charts(scene, rays, {.texels = 32}));
    CHECK(mesh.triangles.size() == 2);
    CHECK(mesh.positions.size() == 4);
}
