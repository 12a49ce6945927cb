// The part of a triangle inside one texel.
#pragma once

#include <array>
#include <optional>

#include <glm/vec2.hpp>

namespace crevice {

// The mean of the corners of what is left of a triangle inside the square from `low` to `low` + 1; inside
// both, up to rounding. Nothing when they do not touch, or when the triangle and the square share an edge or
// a corner only. Sutherland and Hodgman 1974, in double.
std::optional<glm::dvec2> middle_in_square(const std::array<glm::dvec2, 3>& triangle, glm::dvec2 low);

}  // namespace crevice
