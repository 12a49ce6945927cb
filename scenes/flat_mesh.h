// Buildings: flat-shaded meshes from polygons, and the polygons of block solids and prisms.
//
// Object space, scene units, y up; polygons are clockwise seen from their front, so that in these left-handed
// coordinates the arithmetic cross(b - a, c - a) points out of the solid.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/scene/scene.h"

namespace crevice {

// A polygon of at least three corners, all of them visible from the first; planar, or so nearly that one mean
// normal will do.
struct FlatPolygon {
    std::vector<glm::dvec3> corners;
    int material = 0;  // index into Scene::materials, at least 0
};

// One vertex a corner with the polygon's normal, one part a material in ascending order. The texture repeats
// once a scene unit along the two axes across the normal's largest component.
Mesh flat_mesh(std::span<const FlatPolygon> polygons);

// An axis-aligned block, low < high: solid, or with kCarved hollowed out of the blocks before it.
inline constexpr int kCarved = -1;
struct Block {
    glm::dvec3 low, high;
    int material = 0;
};

// The surface of the blocks laid one after the other; where two overlap the later one holds. Closed, without
// T-junctions and without double faces, because all faces are cut along all the blocks' planes.
std::vector<FlatPolygon> block_solid(std::span<const Block> blocks);

// A closed prism along x: `outline` is its cross-section as (y, z), counterclockwise with y to the right and
// z up, all of it visible from its first corner.
std::vector<FlatPolygon> prism_along_x(std::span<const glm::dvec2> outline, double x_low, double x_high,
                                       int material);

}  // namespace crevice
