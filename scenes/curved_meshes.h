// Surfaces that a drawing describes: by a function of two parameters, by a profile on the lathe, or by a
// moulding that runs round a rectangle. Object space, scene units, y up, one part of material 0.
//
// A profile is a line of points from the top downwards, the air on its outer side: a closed one goes down
// outside and up inside. It has an edge where it turns by more than kCrease_rad, and is smooth elsewhere.
#pragma once

#include <functional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/scene/scene.h"

namespace crevice {

inline constexpr double kCrease_rad = 0.7;

// A surface over (u, v) in [0,1]^2. Its front is where u runs to the right and v runs down.
using CurvedSurface = std::function<glm::dvec3(double u, double v)>;

// `columns` by `rows` squares, smooth everywhere, also across the seam of a surface whose u = 1 is its u = 0.
// The texture repeats `repeats` times along u and v. Less than one column or row is a UsageError.
Mesh curved_mesh(const CurvedSurface& surface, int columns, int rows, glm::dvec2 repeats);

// A profile of (radius, y) turned about the y axis from +x over +z, in `slices` pieces of a whole turn, of which
// the first `slices_made` are there: half of an even number is an arch lying down. The texture repeats `repeats`
// times round a whole turn and along the profile. Fewer than 3 slices or 2 points are a UsageError.
Mesh lathe_mesh(std::span<const glm::dvec2> profile, int slices, glm::dvec2 repeats, int slices_made);
Mesh lathe_mesh(std::span<const glm::dvec2> profile, int slices, glm::dvec2 repeats);

// A profile of (distance outward, y) that runs round the rectangle |x| <= half.x, |z| <= half.y, its corners
// mitred, its faces flat: a cornice, a kerb, a wall; of half sides 0 a pillar. Down a profile its front looks
// away from the middle, up a profile towards it. The texture repeats `repeats_a_unit` times a unit.
Mesh frame_mesh(glm::dvec2 half, std::span<const glm::dvec2> profile, double repeats_a_unit);

}  // namespace crevice
