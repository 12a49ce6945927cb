// What the tests of shapes and scenes ask of a mesh.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "rasterizer/scene/scene.h"

namespace crevice {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

inline glm::dvec3 doubled_area_vector(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    const glm::dvec3 a = mesh.positions[triangle[0]], b = mesh.positions[triangle[1]],
                     c = mesh.positions[triangle[2]];
    return glm::cross(b - a, c - a);
}

// Triangles by position instead of by vertex: seams and flat-shaded edges are welded.
inline Triangles welded(const Mesh& mesh) {
    std::map<std::tuple<float, float, float>, std::uint32_t> known;
    Triangles triangles = mesh.triangles;
    for (auto& triangle : triangles) {
        for (std::uint32_t& vertex : triangle) {
            const glm::vec3 p = mesh.positions[vertex];
            const auto next = static_cast<std::uint32_t>(known.size());
            vertex = known.try_emplace({p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}, next).first->second;
        }
    }
    return triangles;
}

// How many directed edges are there more than once, or lack their opposite: 0 for a closed, oriented surface.
inline int open_edges(const Triangles& triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
    }
    int open = 0;
    for (const auto& [edge, count] : edges) {
        const auto opposite = edges.find({edge.second, edge.first});
        if (count != 1 || opposite == edges.end() || opposite->second != 1) ++open;
    }
    return open;
}

// V - E + F of a closed triangle surface: 2 for one like a sphere.
inline int euler_characteristic(const Triangles& triangles) {
    std::set<std::uint32_t> vertices;
    for (const auto& triangle : triangles) vertices.insert(triangle.begin(), triangle.end());
    const int faces = static_cast<int>(triangles.size());
    return static_cast<int>(vertices.size()) - faces * 3 / 2 + faces;
}

// By the divergence theorem; positive when triangles are clockwise seen from outside.
inline double enclosed_volume(const Mesh& mesh) {
    double volume = 0;
    for (const auto& triangle : mesh.triangles) {
        volume += glm::dot(glm::dvec3(mesh.positions[triangle[0]]), doubled_area_vector(mesh, triangle)) / 6;
    }
    return volume;
}

inline Bounds bounds_of(const Mesh& mesh) {
    Scene scene;
    scene.meshes = {mesh};
    scene.instances = {Instance{}};
    return world_bounds(scene);
}

inline void check_bounds(const Bounds& bounds, glm::dvec3 low, glm::dvec3 high, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        CAPTURE(bounds.low[axis]);
        CAPTURE(bounds.high[axis]);
        CHECK(std::abs(bounds.low[axis] - low[axis]) <= tolerance);
        CHECK(std::abs(bounds.high[axis] - high[axis]) <= tolerance);
    }
}

inline void check_well_formed(const Mesh& mesh, int material_count) {
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    CHECK((mesh.texcoords.empty() || mesh.texcoords.size() == mesh.positions.size()));
    int out_of_range = 0, not_unit = 0, turned = 0;
    for (const glm::vec3& n : mesh.normals) not_unit += !(std::abs(glm::length(glm::dvec3(n)) - 1) < 1e-5);
    for (const auto& triangle : mesh.triangles) {
        const std::uint32_t last = *std::max_element(triangle.begin(), triangle.end());
        if (last >= mesh.positions.size()) {
            ++out_of_range;
            continue;
        }
        const glm::dvec3 face = doubled_area_vector(mesh, triangle);
        for (const std::uint32_t vertex : triangle)
            turned += !(glm::dot(face, glm::dvec3(mesh.normals[vertex])) > 0);
    }
    CHECK(out_of_range == 0);
    CHECK(not_unit == 0);
    CHECK(turned == 0);
    std::uint32_t covered = 0;
    for (const MeshPart& part : mesh.parts) {
        CHECK(part.first_triangle == covered);
        CHECK(part.triangle_count > 0);
        CHECK(part.material >= 0);
        CHECK(part.material < material_count);
        covered += part.triangle_count;
    }
    CHECK(covered == mesh.triangles.size());
}

}  // namespace crevice
