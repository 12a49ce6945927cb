#include <limits>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/error.h"
#include "tests/tools/ray_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

TEST_CASE("triangles keep their instance, their number and their material") {
    Scene scene = scene_of({cube(), facing_quad({0, 0, 5}, 1)});
    scene.materials.resize(3);
    scene.meshes[0].parts = {{0, 4, 2}, {4, 8, 1}};
    scene.instances.push_back({0, glm::translate(glm::mat4(1), glm::vec3(10, 0, 0))});
    const RayScene rays = ray_scene(scene, {0, 0, -8});
    REQUIRE(rays.triangles.size() == 26);
    REQUIRE(rays.sources.size() == 26);
    CHECK(rays.sources[3].material == 2);
    CHECK(rays.sources[4].material == 1);
    CHECK(rays.sources[13].instance == 1);
    CHECK(rays.sources[13].triangle == 1);
    CHECK(rays.sources[13].material == 0);
    CHECK(rays.sources[25].instance == 2);
    CHECK(rays.sources[25].triangle == 11);
    // The third instance's cube, ten to the right, its near face 7 in front of the origin of rays.
    const RayHit hit = closest_hit(rays, {{10.5f, 0.25f, 0}, {0, 0, 1}}, kInfinity);
    CHECK(hit.distance == 7);
    REQUIRE(hit.triangle >= 14);
    CHECK(geometric_normal(rays, hit.triangle) == glm::vec3(0, 0, -1));
}

TEST_CASE("normals point to the front, of mirrored instances too") {
    Scene scene = scene_of({cube()});
    for (const float x : {1.0f, -1.0f}) {
        CAPTURE(x);
        scene.instances[0].world_from_object = glm::scale(glm::mat4(1), glm::vec3(x, 1, 1));
        const RayScene rays = ray_scene(scene, {0, 0, 0});
        CHECK(rays.mirrored[0] == (x < 0));
        for (std::int32_t i = 0; i < 12; ++i) {
            CAPTURE(i);
            const Corners& corners = rays.triangles[static_cast<std::size_t>(i)];
            const glm::vec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0f;
            CHECK(glm::dot(geometric_normal(rays, i), centre) ==
                  1);  // outwards; the faces are 1 from the centre
        }
    }
}

TEST_CASE("triangles without area and with corners that are no numbers are left out and counted") {
    Mesh mesh = facing_quad({0, 0, 4}, 1);
    mesh.positions.push_back({kNan, 0, 4});
    mesh.positions.push_back({0, kInfinity, 4});
    mesh.positions.push_back({0, 0, 0x1p37f});
    mesh.triangles.insert(mesh.triangles.begin(), {{0, 1, 4}, {5, 1, 2}, {0, 0, 1}, {0, 6, 1}, {2, 2, 2}});
    mesh.normals.resize(mesh.positions.size(), {0, 0, -1});
    mesh.parts = {{0, 7, 0}};
    const RayScene rays = ray_scene(scene_of({mesh}), glm::dvec3(0));
    CHECK(rays.not_finite == 3);
    CHECK(rays.degenerate == 2);
    REQUIRE(rays.triangles.size() == 2);
    CHECK(rays.sources[0].triangle == 5);
    CHECK(closest_hit(rays, {{0.5f, 0.25f, 0}, {0, 0, 1}}, kInfinity).distance == 4);

    Scene flat = scene_of({cube()});
    flat.instances[0].world_from_object = glm::scale(glm::mat4(1), glm::vec3(1, 0, 0));
    CHECK(ray_scene(flat, glm::dvec3(0)).degenerate == 12);
}

TEST_CASE("a far scene is brought to the eye before it becomes float") {
    // Mesh coordinates on a grid of 1/16, moved by 2^18: a sum of floats would keep 1/32 at best, and this
    // shift by 2^40 nothing.
    Scene scene = still_life();
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions) p = glm::round(p * 16.0f) / 16.0f;
    }
    const RayScene here = ray_scene(scene, {0.125, 0, 0});
    const glm::vec3 far_away(0x1p40f, -0x1p40f, 0x1p39f);
    for (Instance& instance : scene.instances)
        instance.world_from_object = glm::translate(instance.world_from_object, far_away);
    const RayScene there = ray_scene(scene, glm::dvec3(far_away) + glm::dvec3(0.125, 0, 0));
    REQUIRE(there.triangles.size() == here.triangles.size());
    CHECK(there.triangles == here.triangles);
    CHECK(here.degenerate == there.degenerate);
}

TEST_CASE("an origin that is not a number is refused") {
    for (const double x :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        CAPTURE(x);
        CHECK_THROWS_AS(ray_scene(still_life(), {0, x, 0}), UsageError);
    }
}
