// Rays from one point of a scene, in the plane x = 0: view z to the right, y up, as in the other sections.
#pragma once

#include <string>
#include <vector>

#include "chapters/diagrams/section_drawing.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

struct RayFan {
    std::string svg;
    int blocked = 0;  // of the rays
};

// From `p` on a floor y = 0 one ray at each angle, radians from +z towards +y: red as far as what it meets within `length`,
// else blue and that long. `rays` is relative to the world's origin. `outline` is what to draw of the scene.
RayFan ray_fan(const RayScene& rays, SectionPoint p, const std::vector<double>& angles_rad, double length,
               const std::vector<SectionPoint>& outline, const std::string& title);

}  // namespace crevice
