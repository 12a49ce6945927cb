// A flat disc of slivers round one vertex: the mesh that geometry calls open everywhere and rounding does not.
#pragma once

#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/small_scenes.h"

namespace crevice {

inline constexpr std::uint32_t kSlivers = 20000;

// A disc in a plane askew to the axes, in front of an eye at the origin.
inline Scene fan_scene(bool reversed) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.5, 0.7, -1)), centre = {0.1, -0.2, 4};
    const glm::dvec3 right = glm::normalize(glm::cross(normal, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, normal);
    Mesh mesh;
    mesh.positions = {glm::vec3(centre)};
    for (std::uint32_t i = 0; i < kSlivers; ++i) {
        const double angle = 2 * kPi * i / kSlivers;
        mesh.positions.emplace_back(centre + 1.5 * (std::cos(angle) * right + std::sin(angle) * up));
        const std::uint32_t here = 1 + i, next = 1 + (i + 1) % kSlivers;
        mesh.triangles.push_back({0, reversed ? here : next, reversed ? next : here});
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(reversed ? -normal : normal));
    mesh.parts = {{0, kSlivers, 0}};
    Scene scene = scene_of({mesh});
    scene.two_sided = true;
    return scene;
}

}  // namespace crevice
