#include "scenes/shapes.h"

#include <string>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "scenes/lattice_mesh.h"

namespace crevice {
namespace {

using Index = std::uint32_t;

void require_at_least(int least, int value, const char* name) {
    if (value < least) {
        throw UsageError(std::string(name) + " is too small (" + std::to_string(value) + "); give at least " +
                         std::to_string(least));
    }
}

void add_cap(Mesh& mesh, double y, double radius, double height, int slices) {
    const glm::dvec3 up(0, y > 0 ? 1 : -1, 0);
    const auto first = static_cast<Index>(mesh.positions.size());
    for (int j = 0; j <= slices; ++j) {
        const glm::dvec2 at = radius * slice_direction(j, slices);
        add_vertex(mesh, {at.x, y, at.y}, up, at / height + 0.5);
    }
    const auto centre = static_cast<Index>(mesh.positions.size());
    add_vertex(mesh, {0, y, 0}, up, glm::dvec2(0.5));
    for (Index j = first; j + 1 < centre; ++j) {
        if (y > 0) {
            mesh.triangles.push_back({centre, j + 1, j});
        } else {
            mesh.triangles.push_back({centre, j, j + 1});
        }
    }
}

}  // namespace

Mesh grid_mesh(double width, double depth, int rows, int columns, glm::dvec2 repeats) {
    require_at_least(2, rows, "rows");
    require_at_least(2, columns, "columns");
    Mesh mesh;
    for (int i = 0; i < rows; ++i) {
        const double v = static_cast<double>(i) / (rows - 1);
        for (int j = 0; j < columns; ++j) {
            const double u = static_cast<double>(j) / (columns - 1);
            add_vertex(mesh, {(u - 0.5) * width, 0, (0.5 - v) * depth}, {0, 1, 0},
                       glm::dvec2(u, v) * repeats);
        }
    }
    add_lattice_triangles(mesh, 0, rows, columns);
    return as_one_part(std::move(mesh));
}

Mesh box_mesh(glm::dvec3 size, int cells) {
    require_at_least(1, cells, "cells");
    // Each face: its outward normal, and its texture's u and v directions seen from outside.
    struct Face {
        glm::dvec3 normal, right, down;
    };
    static constexpr Face kFaces[] = {
        {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},   {{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}},
        {{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};
    Mesh mesh;
    for (const Face& face : kFaces) {
        const int first = static_cast<int>(mesh.positions.size());
        for (int i = 0; i <= cells; ++i) {
            for (int j = 0; j <= cells; ++j) {
                const double u = static_cast<double>(j) / cells, v = static_cast<double>(i) / cells;
                const glm::dvec3 corner = 0.5 * face.normal + (u - 0.5) * face.right + (v - 0.5) * face.down;
                add_vertex(mesh, corner * size, face.normal, {u, v});
            }
        }
        add_lattice_triangles(mesh, first, cells + 1, cells + 1);
    }
    return as_one_part(std::move(mesh));
}

Mesh sphere_mesh(double radius, int slices, int stacks) {
    require_at_least(3, slices, "slices");
    require_at_least(2, stacks, "stacks");
    Mesh mesh;
    add_vertex(mesh, {0, radius, 0}, {0, 1, 0}, {0, 0});
    for (int i = 1; i < stacks; ++i) {
        const double v = static_cast<double>(i) / stacks;
        const SineCosine from_pole = sine_cosine(kPi * v);
        for (int j = 0; j <= slices; ++j) {
            const glm::dvec2 around = from_pole.sine * slice_direction(j, slices);
            const glm::dvec3 normal(around.x, from_pole.cosine, around.y);
            add_vertex(mesh, radius * normal, normal, {static_cast<double>(j) / slices, v});
        }
    }
    add_vertex(mesh, {0, -radius, 0}, {0, -1, 0}, {0, 1});

    const auto ring = static_cast<Index>(slices);
    for (Index j = 1; j <= ring; ++j) mesh.triangles.push_back({0, j + 1, j});
    add_lattice_triangles(mesh, 1, stacks - 1, slices + 1);
    const auto south = static_cast<Index>(mesh.positions.size()) - 1;
    for (Index j = south - ring - 1; j + 1 < south; ++j) mesh.triangles.push_back({south, j, j + 1});
    return as_one_part(std::move(mesh));
}

Mesh cylinder_mesh(double bottom_radius, double top_radius, double height, int slices, int stacks) {
    require_at_least(3, slices, "slices");
    require_at_least(1, stacks, "stacks");
    Mesh mesh;
    // From the top ring down, so that rows run down the texture; the book starts at the bottom and draws the
    // same surface.
    for (int i = 0; i <= stacks; ++i) {
        const double v = static_cast<double>(i) / stacks;
        const double radius = top_radius + v * (bottom_radius - top_radius);
        for (int j = 0; j <= slices; ++j) {
            const glm::dvec2 around = slice_direction(j, slices);
            const glm::dvec3 normal(height * around.x, bottom_radius - top_radius, height * around.y);
            add_vertex(mesh, {radius * around.x, (0.5 - v) * height, radius * around.y}, normal,
                       {static_cast<double>(j) / slices, v});
        }
    }
    add_lattice_triangles(mesh, 0, stacks + 1, slices + 1);
    add_cap(mesh, 0.5 * height, top_radius, height, slices);
    add_cap(mesh, -0.5 * height, bottom_radius, height, slices);
    return as_one_part(std::move(mesh));
}

Mesh with_material(Mesh mesh, int material) {
    for (MeshPart& part : mesh.parts) part.material = material;
    return mesh;
}

}  // namespace crevice
