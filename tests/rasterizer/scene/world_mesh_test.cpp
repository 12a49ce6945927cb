#include "rasterizer/scene/world_mesh.h"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scenes/builtin_scenes.h"
#include "tests/tools/cube_scene.h"
#include "tests/tools/mesh_checks.h"

using namespace crevice;

TEST_CASE("world_mesh: an identity instance keeps every bit") {
    const Scene scene = scene_of(cube(), glm::mat4(1));
    const Mesh mesh = world_mesh(scene);
    CHECK(mesh.positions == scene.meshes[0].positions);
    CHECK(mesh.normals == scene.meshes[0].normals);
    CHECK(mesh.triangles == scene.meshes[0].triangles);
}

TEST_CASE("world_mesh: instances one after the other, fronts stay fronts, normals stay perpendicular") {
    Scene scene = scene_of(cube(), glm::mat4(1));
    scene.materials.resize(2);
    scene.meshes[0].parts = {{0, 4, 1}, {4, 8, 0}};
    RandomSequence random(5);
    // Turned before it is scaled: the normals' own transform differs from that of the positions.
    const glm::mat3 askew(random_rotation(random));
    for (auto* vectors : {&scene.meshes[0].positions, &scene.meshes[0].normals}) {
        for (glm::vec3& v : *vectors) v = askew * v;
    }
    for (const double mirror : {1.0, -1.0}) {
        CAPTURE(mirror);
        const glm::dmat4 turn(random_rotation(random));
        const glm::mat4 placed(glm::translate(glm::dmat4(1), glm::dvec3(3, -2, 7)) * turn *
                               glm::scale(glm::dmat4(1), glm::dvec3(2 * mirror, 0.25, 1)));
        scene.instances = {{0, glm::mat4(1)}, {0, placed}};
        const Mesh mesh = world_mesh(scene);
        check_well_formed(mesh, 2);  // the normals are unit and in front of their triangles
        REQUIRE(mesh.positions.size() == 48);
        REQUIRE(mesh.triangles.size() == 24);
        REQUIRE(mesh.parts.size() == 4);
        CHECK(mesh.parts[2].first_triangle == 12);
        CHECK(mesh.parts[2].material == 1);
        CHECK(enclosed_volume(mesh) == doctest::Approx(8 + 4).epsilon(1e-6));
        for (std::size_t t = 12; t < 24; ++t) {
            const glm::dvec3 face = glm::normalize(doubled_area_vector(mesh, mesh.triangles[t]));
            CHECK(glm::dot(face, glm::dvec3(mesh.normals[mesh.triangles[t][0]])) > 1 - 1e-6);
        }
        const glm::dvec3 corner = glm::dmat4(placed) * glm::dvec4(scene.meshes[0].positions[5], 1);
        CHECK(mesh.positions[24 + 5] == glm::vec3(corner));
    }
}

TEST_CASE("world_mesh: the built-in scenes are as large as their bounds") {
    for (const char* name : {"columns", "empty"}) {
        CAPTURE(name);
        const Scene scene = find_builtin_scene(name)->make();
        const Mesh mesh = world_mesh(scene);
        CHECK(mesh.triangles.size() == triangle_count(scene));
        CHECK(mesh.normals.size() == mesh.positions.size());
        const Bounds bounds = world_bounds(scene);
        CHECK(bounds.empty == mesh.positions.empty());
        if (!bounds.empty) check_bounds(bounds_of(mesh), bounds.low, bounds.high, 1e-5);
    }
}
