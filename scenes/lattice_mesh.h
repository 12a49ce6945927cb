// What meshes are knitted from: vertices in rows and columns, two triangles a square.
#pragma once

#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/scene/scene.h"
#include "rasterizer/scene/vertex_normals.h"

namespace crevice {

// The normal need not be unit.
inline void add_vertex(Mesh& mesh, glm::dvec3 position, glm::dvec3 normal, glm::dvec2 texcoord) {
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(glm::normalize(normal));
    mesh.texcoords.emplace_back(texcoord);
}

// The triangles of each square of a lattice of `rows` by `columns` vertices whose rows follow one another:
// `first` is the lattice's first vertex, and the front is the side from which columns run to the right and
// rows run down. Where two corners of a triangle coincide, as at a pole, there is none.
inline void add_lattice_triangles(Mesh& mesh, int first, int rows, int columns) {
    const auto add = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
        if (p != q && q != r && r != p) mesh.triangles.push_back({a, b, c});
    };
    for (int row = 0; row + 1 < rows; ++row) {
        for (int column = 0; column + 1 < columns; ++column) {
            const auto a = static_cast<std::uint32_t>(first + row * columns + column);
            const auto below = a + static_cast<std::uint32_t>(columns);
            add(a, a + 1, below);
            add(below, a + 1, below + 1);
        }
    }
}

// The whole mesh as a part of one material.
inline Mesh as_one_part(Mesh mesh, int material = 0) {
    mesh.parts = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), material}};
    return mesh;
}

// One normal a position, the surface smooth everywhere (vertex_normals.h).
inline std::vector<glm::vec3> smooth_normals(const Mesh& mesh, const Run& run) {
    const CornerNormals at =
        angle_weighted_normals(mesh.positions, mesh.triangles, kSmoothEverywhere_rad, {}, run);
    std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) normals[mesh.triangles[t][k]] = at.normals[at.of_triangle[t][k]];
    }
    return normals;
}

// The direction of slice `j` of `slices`, in the xz plane: from +x over +z. The seam closes exactly.
inline glm::dvec2 slice_direction(int j, int slices) {
    const SineCosine at = sine_cosine(2 * kPi * (j % slices) / slices);
    return {at.cosine, at.sine};
}

}  // namespace crevice
