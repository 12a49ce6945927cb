#include "rasterizer/scene/scene.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("world_bounds and triangle_count go by instance") {
    Scene scene;
    CHECK(world_bounds(scene).empty);
    scene.meshes.resize(2);
    scene.meshes[0].positions = {{0, 0, 0}, {1, 2, 3}};
    scene.meshes[0].triangles.resize(5);
    scene.meshes[1].positions = {{1e6f, 0, 0}};  // stands nowhere
    glm::mat4 moved(1.0f);
    moved[0][0] = -2;
    moved[3] = {10, 0, 0, 1};
    scene.instances = {{0, glm::mat4(1.0f)}, {0, moved}};
    CHECK(triangle_count(scene) == 10);
    const Bounds bounds = world_bounds(scene);
    CHECK_FALSE(bounds.empty);
    CHECK(bounds.low == glm::dvec3(0, 0, 0));
    CHECK(bounds.high == glm::dvec3(10, 2, 3));
}
