// What independent texts of the methods read of a depth map.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// The point, view space, that the depth map shows in the pixel around (at_x, at_y); far away beyond the picture.
inline glm::dvec3 surface_at(const AoInputs& inputs, double at_x, double at_y) {
    const Size picture = inputs.picture;
    const double x = std::floor(at_x), y = std::floor(at_y);
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return glm::dvec3(1e9);
    const double z = inputs.depth_map.at(static_cast<int>(x) + 1, static_cast<int>(y) + 1);
    return {z * static_cast<double>(inputs.rays.ray_scale.x) * (2 * (x + 0.5) / picture.width - 1),
            z * static_cast<double>(inputs.rays.ray_scale.y) * (1 - 2 * (y + 0.5) / picture.height), z};
}

}  // namespace crevice
