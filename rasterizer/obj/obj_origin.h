// Scenes far from the origin of their coordinates, such as buildings in UTM metres.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace crevice {

// Whether positions lie so far from the origin for their extent that float rounds away more than eight of its
// 24 bits of them, or all. Those that no face uses (`used`, one a position) or that are not finite have no
// say.
bool lie_far(std::span<const glm::vec3> positions, const std::vector<bool>& used);

// A point in the middle of positions. Its coordinates are multiples of a power of two above their extent, so
// that subtracting it in double changes no digit. 0 when they have no extent.
glm::dvec3 near_origin(std::span<const glm::dvec3> positions, const std::vector<bool>& used);

// What is said of it.
std::string origin_warning(glm::dvec3 origin);

}  // namespace crevice
