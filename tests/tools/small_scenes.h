// Meshes of a few triangles, and scenes made of them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/scene/scene.h"
#include "tests/tools/random_sequence.h"

namespace crevice {

// A rectangle given by its corners, clockwise seen from its front; texture (0,0) at the first corner, (1,0)
// at the second.
inline Mesh quad_mesh(std::array<glm::vec3, 4> corners, glm::vec3 normal) {
    Mesh mesh;
    mesh.positions.assign(corners.begin(), corners.end());
    mesh.normals.assign(4, normal);
    mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.parts = {{0, 2, 0}};
    return mesh;
}

// A square with sides of 2 * half that faces an eye looking along +z.
inline Mesh facing_quad(glm::vec3 centre, float half) {
    const auto corner = [&](float x, float y) { return centre + half * glm::vec3(x, y, 0); };
    return quad_mesh({corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1)}, {0, 0, -1});
}

// Meshes as they are, one material, the eye at the origin looking along +z.
inline Scene scene_of(std::vector<Mesh> meshes) {
    Scene scene;
    scene.name = "test";
    scene.materials.emplace_back();
    scene.ambient_light = glm::vec3(0.5f);
    scene.lights[0].direction = {0, 0, 1};
    scene.lights[0].diffuse = glm::vec3(0.5f);
    scene.camera.eye = {0, 0, 0};
    scene.camera.target = {0, 0, 1};
    for (std::size_t i = 0; i < meshes.size(); ++i)
        scene.instances.push_back({static_cast<int>(i), glm::mat4(1.0f)});
    scene.meshes = std::move(meshes);
    return scene;
}

// Scene and camera with all lengths times 2^k, which is exact.
inline Scene scaled(Scene scene, int k) {
    const float factor = std::ldexp(1.0f, k);
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions) p *= factor;
    }
    for (Instance& instance : scene.instances) {
        for (int i = 0; i < 3; ++i) instance.world_from_object[3][i] *= factor;
    }
    Camera& camera = scene.camera;
    const double longer = factor;
    camera.eye *= longer;
    camera.target *= longer;
    camera.near_plane *= longer;
    camera.far_plane *= longer;
    camera.ortho_height *= longer;
    return scene;
}

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
