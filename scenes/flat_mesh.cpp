#include "scenes/flat_mesh.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/geometric.hpp>

namespace crevice {
namespace {

glm::dvec3 normal_of(const FlatPolygon& polygon) {
    glm::dvec3 doubled_area(0);
    for (std::size_t i = 1; i + 1 < polygon.corners.size(); ++i) {
        doubled_area +=
            glm::cross(polygon.corners[i] - polygon.corners[0], polygon.corners[i + 1] - polygon.corners[0]);
    }
    return glm::normalize(doubled_area);
}

glm::dvec2 planar_texcoord(glm::dvec3 p, glm::dvec3 normal) {
    const glm::dvec3 size = glm::abs(normal);
    if (size.y >= size.x && size.y >= size.z) return {p.x, -p.z};
    return {size.x >= size.z ? p.z : p.x, -p.y};
}

// The planes of all blocks across one axis, ascending. Planes closer than a thousandth of a unit are one.
std::vector<double> planes_of(std::span<const Block> blocks, int axis) {
    std::vector<double> planes;
    for (const Block& block : blocks) {
        planes.push_back(block.low[axis]);
        planes.push_back(block.high[axis]);
    }
    std::sort(planes.begin(), planes.end());
    const auto same = [](double a, double b) { return b - a < 1e-3; };
    planes.erase(std::unique(planes.begin(), planes.end(), same), planes.end());
    return planes;
}

// The cells between the planes, and what each is made of.
struct BlockGrid {
    std::array<std::vector<double>, 3> planes;
    std::vector<int> materials;

    glm::ivec3 cells() const { return {planes[0].size() - 1, planes[1].size() - 1, planes[2].size() - 1}; }
    glm::dvec3 corner(glm::ivec3 at) const {
        return {planes[0][std::size_t(at.x)], planes[1][std::size_t(at.y)], planes[2][std::size_t(at.z)]};
    }
    int& material(glm::ivec3 cell) {
        return materials[std::size_t((cell.z * cells().y + cell.y) * cells().x + cell.x)];
    }
};

template <class Body>
void for_each_cell(glm::ivec3 cells, Body body) {
    for (int z = 0; z < cells.z; ++z) {
        for (int y = 0; y < cells.y; ++y) {
            for (int x = 0; x < cells.x; ++x) body(glm::ivec3(x, y, z));
        }
    }
}

BlockGrid fill(std::span<const Block> blocks) {
    BlockGrid grid{{planes_of(blocks, 0), planes_of(blocks, 1), planes_of(blocks, 2)}, {}};
    const glm::ivec3 cells = grid.cells();
    grid.materials.assign(std::size_t(cells.x * cells.y * cells.z), kCarved);
    for_each_cell(cells, [&](glm::ivec3 cell) {
        const glm::dvec3 middle = 0.5 * (grid.corner(cell) + grid.corner(cell + 1));
        for (const Block& block : blocks) {
            const bool inside = middle.x > block.low.x && middle.y > block.low.y && middle.z > block.low.z &&
                                middle.x < block.high.x && middle.y < block.high.y && middle.z < block.high.z;
            if (inside) grid.material(cell) = block.material;
        }
    });
    return grid;
}

// The face of a cell on the low (side 0) or high (side 1) end of an axis, turned outward.
FlatPolygon cell_face(const BlockGrid& grid, glm::ivec3 cell, int axis, int side, int material) {
    glm::ivec3 along_u(0), along_v(0), first = cell;
    along_u[(axis + 1) % 3] = 1;
    along_v[(axis + 2) % 3] = 1;
    first[axis] += side;
    if (side == 0) std::swap(along_u, along_v);
    return {{grid.corner(first), grid.corner(first + along_u), grid.corner(first + along_u + along_v),
             grid.corner(first + along_v)},
            material};
}

}  // namespace

Mesh flat_mesh(std::span<const FlatPolygon> polygons) {
    int material_count = 0;
    for (const FlatPolygon& polygon : polygons)
        material_count = std::max(material_count, polygon.material + 1);
    Mesh mesh;
    for (int material = 0; material < material_count; ++material) {
        const auto first_triangle = static_cast<std::uint32_t>(mesh.triangles.size());
        for (const FlatPolygon& polygon : polygons) {
            if (polygon.material != material) continue;
            const glm::dvec3 normal = normal_of(polygon);
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const glm::dvec3& corner : polygon.corners) {
                mesh.positions.emplace_back(corner);
                mesh.normals.emplace_back(normal);
                mesh.texcoords.emplace_back(planar_texcoord(corner, normal));
            }
            const auto end = static_cast<std::uint32_t>(mesh.positions.size());
            for (std::uint32_t i = first + 1; i + 1 < end; ++i) mesh.triangles.push_back({first, i, i + 1});
        }
        const auto count = static_cast<std::uint32_t>(mesh.triangles.size()) - first_triangle;
        if (count > 0) mesh.parts.push_back({first_triangle, count, material});
    }
    return mesh;
}

std::vector<FlatPolygon> block_solid(std::span<const Block> blocks) {
    BlockGrid grid = fill(blocks);
    const glm::ivec3 cells = grid.cells();
    std::vector<FlatPolygon> faces;
    for_each_cell(cells, [&](glm::ivec3 cell) {
        const int material = grid.material(cell);
        if (material == kCarved) return;
        for (int axis = 0; axis < 3; ++axis) {
            for (int side = 0; side < 2; ++side) {
                glm::ivec3 neighbour = cell;
                neighbour[axis] += 2 * side - 1;
                const bool outside = neighbour[axis] < 0 || neighbour[axis] >= cells[axis];
                if (outside || grid.material(neighbour) == kCarved) {
                    faces.push_back(cell_face(grid, cell, axis, side, material));
                }
            }
        }
    });
    return faces;
}

std::vector<FlatPolygon> prism_along_x(std::span<const glm::dvec2> outline, double x_low, double x_high,
                                       int material) {
    FlatPolygon low_end{{}, material}, high_end{{}, material};
    std::vector<FlatPolygon> faces;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        const glm::dvec2 mirrored = outline[(outline.size() - i) % outline.size()];
        faces.push_back(
            {{{x_high, a.x, a.y}, {x_low, a.x, a.y}, {x_low, b.x, b.y}, {x_high, b.x, b.y}}, material});
        high_end.corners.emplace_back(x_high, a.x, a.y);
        low_end.corners.emplace_back(x_low, mirrored.x, mirrored.y);
    }
    faces.push_back(low_end);
    faces.push_back(high_end);
    return faces;
}

}  // namespace crevice
