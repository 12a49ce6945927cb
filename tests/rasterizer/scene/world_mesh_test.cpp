#include "rasterizer/scene/world_mesh.h"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/tools/mesh_checks.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

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
