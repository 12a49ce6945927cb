// How chapter 04 gets from a depth to a point: along the eye's ray through a texel.
#pragma once

#include <string>

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// The ray through texel (x, y) up to the point `p_view` on it, in the vertical plane that holds it; and of the depth map
// the ground, up to where something stands in front of it.
std::string eye_ray(const AoInputs& inputs, int x, int y, Vec3<float> p_view);

}  // namespace crevice
