// Simple surfaces as meshes: grid, box, sphere, cylinder. Tessellation and texture coordinates are those of
// the GeometryGenerator that Luna builds the scene with: slices run around the y axis from +x
// over +z, the seam's vertices are there twice, texture v = 0 is the top row.
//
// All lengths are scene units in object space, all shapes stand around the origin with y up, every mesh is
// one part of material 0. Trigonometry is done in double and rounded once. A count below the least one stated
// is a UsageError.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/scene/scene.h"

namespace crevice {

// The y = 0 rectangle of width (x) by depth (z), facing up, with `rows` vertices along z (from the far edge
// to the near one) and `columns` along x; both at least 2. The texture repeats `repeats` times along x and z.
// rows * columns vertices, 2 (rows - 1) (columns - 1) triangles.
Mesh grid_mesh(double width, double depth, int rows, int columns, glm::dvec2 repeats = glm::dvec2(1));

// A closed box, each face cut into cells * cells squares: `cells` = 2^n is the book's box subdivided n times
// (with each vertex once a face instead of once a triangle). 6 (cells + 1)^2 vertices, 12 cells^2 triangles.
Mesh box_mesh(glm::dvec3 size, int cells = 1);

// A sphere of `stacks` bands from pole to pole, each of `slices` pieces (at least 3; stacks at least 2),
// inscribed in the given radius: the poles and all vertices lie on it. (stacks - 1) (slices + 1) + 2
// vertices, 2 slices (stacks - 1) triangles.
Mesh sphere_mesh(double radius, int slices, int stacks);

// A cylinder, or a cone frustum, with both ends capped, from y = -height/2 to height/2; radii above 0, slices
// at least 3. (stacks + 1) (slices + 1) + 2 (slices + 2) vertices, 2 slices (stacks + 1) triangles.
Mesh cylinder_mesh(double bottom_radius, double top_radius, double height, int slices, int stacks);

// The mesh with all its parts made of one material (an index into Scene::materials).
Mesh with_material(Mesh mesh, int material);

}  // namespace crevice
