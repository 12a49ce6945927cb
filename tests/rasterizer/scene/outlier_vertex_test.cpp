// One far vertex is named; a scene that is merely long is not.
#include "rasterizer/scene/outlier_vertex.h"

#include <limits>

#include <doctest/doctest.h>

#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

// Three squares of side 2, one behind the other.
Scene squares() {
    std::vector<Mesh> meshes;
    for (const float z : {3.0f, 4.0f, 5.0f})
        meshes.push_back(quad_mesh({glm::vec3(-1, 1, z), {1, 1, z}, {1, -1, z}, {-1, -1, z}}, {0, 0, -1}));
    return scene_of(meshes);
}

}  // namespace

TEST_CASE("outlier vertex: the one that stretches the bounds, by how much, wherever it is") {
    for (const float far : {1e3f, -4e5f}) {
        Scene scene = squares();
        scene.meshes[2].positions[3] = {1, far, 2};
        const std::optional<OutlierVertex> found = outlier_vertex(scene);
        REQUIRE(found.has_value());
        CHECK(found->p_world == glm::dvec3(1, static_cast<double>(far), 2));
        CHECK(found->stretch > 50);
    }
}

TEST_CASE("outlier vertex: none of a few vertices, where none is far, or where one is no number") {
    CHECK(!outlier_vertex(Scene{}));
    CHECK(!outlier_vertex(squares()));
    Scene scene = squares();
    scene.meshes[0].positions[0].x = std::numeric_limits<float>::infinity();
    CHECK(!outlier_vertex(scene));
}

TEST_CASE("outlier vertex: a far part, of which the picture would show little else than nothing") {
    // A room of 4 units, and a triangle at x.
    const auto room_and_triangle = [](float x) {
        std::vector<Mesh> meshes = {
            quad_mesh({glm::vec3(0, 0, 4), {4, 0, 4}, {4, 0, 0}, {0, 0, 0}}, {0, 1, 0}),
            quad_mesh({glm::vec3(0, 3, 4), {4, 3, 4}, {4, 0, 4}, {0, 0, 4}}, {0, 0, -1})};
        Mesh far = quad_mesh({glm::vec3(x, 1, 0), {x, 1, 1}, {x, 0, 1}, {x, 0, 0}}, {-1, 0, 0});
        far.triangles.resize(1);
        meshes.push_back(far);
        return scene_of(meshes);
    };
    for (const float x : {25.0f, 50.0f, 100.0f, -50.0f, 400.0f, 1e6f}) {
        CAPTURE(x);
        const std::optional<OutlierVertex> found = outlier_vertex(room_and_triangle(x));
        REQUIRE(found.has_value());
        CHECK(found->p_world.x == static_cast<double>(x));
        CHECK(found->stretch > kPartStretch);
    }
    for (const float x : {4.0f, 8.0f, 12.0f}) {
        CAPTURE(x);
        CHECK(!outlier_vertex(room_and_triangle(x)));
    }
    // On both sides, and on a ground that reaches to it.
    Scene both = room_and_triangle(50);
    both.meshes.push_back(facing_quad({-50, 0, 0}, 0.5f));
    both.meshes.back().triangles.resize(1);
    both.instances.push_back({3, glm::mat4(1.0f)});
    CHECK(outlier_vertex(both).has_value());
    Scene grounded = room_and_triangle(50);
    grounded.meshes.push_back(
        quad_mesh({glm::vec3(-60, 0, 60), {60, 0, 60}, {60, 0, -60}, {-60, 0, -60}}, {0, 1, 0}));
    grounded.instances.push_back({3, glm::mat4(1.0f)});
    CHECK(!outlier_vertex(grounded));
}

TEST_CASE("outlier vertex: ordinary scenes of several parts are not stretched") {
    // A house on a ground a thousand times as large, a row of squares far apart, two of them, a scatter
    // around one that has most triangles.
    Scene ground = squares();
    ground.meshes.push_back(quad_mesh(
        {glm::vec3(-2000, -1, 2000), {2000, -1, 2000}, {2000, -1, -2000}, {-2000, -1, -2000}}, {0, 1, 0}));
    ground.instances.push_back({3, glm::mat4(1.0f)});
    CHECK(!outlier_vertex(ground));
    std::vector<Mesh> row;
    for (const float x : {0.0f, 12.0f, 24.0f}) row.push_back(facing_quad({x, 0, 5}, 1));
    CHECK(!outlier_vertex(scene_of(row)));
    row.resize(2);
    CHECK(!outlier_vertex(scene_of(row)));
    std::vector<Mesh> scatter(20, facing_quad({50, 0, 5}, 2));
    for (int i = 0; i <= 10; ++i) scatter.push_back(facing_quad({10.0f * static_cast<float>(i), 0, 5}, 0.5f));
    CHECK(!outlier_vertex(scene_of(scatter)));
}
