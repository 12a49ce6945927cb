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
