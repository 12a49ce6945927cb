// A cube to draw, and scenes of one mesh, for tests.
#pragma once

#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/scene/scene.h"
#include "tests/tools/clip_space_scene.h"

namespace crevice {

// A cube from -1 to 1, every face with its own four corners and its outward normal; front faces clockwise
// from outside.
inline Mesh cube() {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 n(0), u(0), v(0);
            n[axis] = side;
            u[(axis + 1) % 3] = 1;
            v[(axis + 2) % 3] = side;
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const glm::vec3 p : {n - u - v, n + u - v, n + u + v, n - u + v}) {
                mesh.positions.push_back(p);
                mesh.normals.push_back(n);
            }
            // u x v = n: counter-clockwise in a right-handed drawing, so clockwise in this left-handed world.
            mesh.triangles.push_back({first, first + 1, first + 2});
            mesh.triangles.push_back({first, first + 2, first + 3});
        }
    }
    mesh.parts = {{0, 12, 0}};
    return mesh;
}

inline Scene scene_of(Mesh mesh, const glm::mat4& world_from_object) {
    Scene scene;
    scene.meshes = {std::move(mesh)};
    scene.instances = {{0, world_from_object}};
    scene.materials = {Material{}};
    return scene;
}

inline glm::dmat3 random_rotation(RandomSequence& random) {
    const glm::dvec3 axis{random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)};
    return glm::dmat3(glm::rotate(glm::dmat4(1), random.between(0, 6.28), glm::normalize(axis)));
}

}  // namespace crevice
