// A closed, even mesh of the unit sphere to model on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace crevice {

struct CubeSphere {
    std::vector<glm::dvec3> directions;                   // unit, 6 cells^2 + 2 of them
    std::vector<std::array<std::uint32_t, 3>> triangles;  // 12 cells^2, clockwise seen from outside
};

// A cube's faces, each of cells * cells squares of equal angle, blown up to the sphere. Every vertex is there
// once, also along the cube's edges, so the surface is closed: each edge belongs to two triangles. Fewer
// than one cell is a UsageError.
CubeSphere cube_sphere(int cells);

}  // namespace crevice
