// Leaves: squares of two triangles out of which a leaf is cut.
#pragma once

#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/scene/scene.h"

namespace crevice {

inline constexpr double kGoldenAngle_rad = 2.39996322972865;  // from one to the next around what they grow on

// Right-angled unit axes of which y points along a unit direction, and z away from `facing` as nearly as can
// be.
glm::dmat3 axes_along(glm::dvec3 direction, glm::dvec3 facing);

// A direction `tilt` away from another, `turn` around it.
glm::dvec3 branching_off(glm::dvec3 direction, double tilt_rad, double turn_rad);

// The square of the leaf's texture, 1 wide, facing -z, its stalk's end at the origin and its tip up.
Mesh leaf_mesh(int material);

// Materials of one leaf's texture, one a tint, which multiplies it.
std::vector<Material> leaf_materials(std::span<const glm::vec3> tints, const Run& run);

}  // namespace crevice
