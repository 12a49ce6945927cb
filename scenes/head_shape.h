// The carved head as a solid: how far off its surface points lie.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "rasterizer/base/run.h"

namespace crevice {

// As many points as the widest kernel takes at a time.
using PointGroup = std::array<glm::dvec3, kMostLanes>;
using Distances = std::array<double, kMostLanes>;

// In object units, negative inside: exact on the surface, a good estimate near it.
Distances head_distances(const PointGroup& points, const Run& run);

}  // namespace crevice
