// The scenes of the stiff cases. Coordinates are floats that stay floats when they are moved far away.
#pragma once

#include "chapters/stability/stiff_cases.h"

namespace crevice {

// A floor, a wall and a block at their corner; coordinates are quarters, the eye is no float.
StiffView block_view();
// A floor and a wall, for scales.
StiffView corner_view();

StiffView tilted_plane_view(double degrees);
StiffView far_plane_view(double z);
StiffView tessellated_plane_view(int cells);
StiffView huge_triangle_view();
StiffView sliver_plane_view();
StiffView stretched_plane_view(double factor);
StiffView mirrored_plane_view();
StiffView singular_view();
StiffView inside_view();
StiffView on_surface_view();
StiffView intersecting_view();
// A ground of 20,000 units below the eye that fills the lower half of the picture and reaches behind the eye.
StiffView ground_view();
// The block with its eye turned away.
StiffView behind_view();
// The block, and behind the eye a triangle a million units away.
StiffView far_vertex_view();

// All lengths times 2^k, the unit of lengths with them.
StiffView scaled(StiffView view, int k);
// Scene and camera moved along all three axes.
StiffView moved(StiffView view, double away);
// Every mesh drawn twice.
StiffView doubled(StiffView view);
StiffView with_normals(StiffView view, glm::vec3 normal);

}  // namespace crevice
