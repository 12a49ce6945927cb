// Ray-cast accessibility over its closed form, for the two scenes that the tutorials' pictures are made of: a
// sphere on a floor and a long wall.
// Source: sphere: the cosine-weighted solid angle of a cap; wall: the same of a wedge, cut at the rays'
//         length. See sphere_on_plane_scene() and wall_corner_scene().
#pragma once

#include <cstdint>

#include "chapters/notebook/plot.h"

namespace crevice {

struct ClosedFormPlot {
    Plot plot;         // accessibility over the distance, 0 to 4 scene units; closed forms lines, rays dots
    double worst = 0;  // the largest difference between dots and lines
};

// On the floor at x from where a unit sphere touches it; rays of any length.
ClosedFormPlot sphere_on_plane_plot(int rays, std::uint32_t seed);

// On the floor at x from a long wall; rays of length 4, so that at x = 4 it ends to matter.
ClosedFormPlot long_wall_plot(int rays, std::uint32_t seed);

}  // namespace crevice
