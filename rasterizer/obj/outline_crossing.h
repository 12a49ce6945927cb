// Whether the outline of a polygon in the plane crosses itself.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace crevice {

// Twice the signed area of a triangle, positive when counter-clockwise. Exact in sign for points whose
// coordinates are floats of similar magnitude.
inline double area2(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Whether two edges of the closed outline cross at a point inside both; `outline` holds indices into
// `points`. Touching is none: bridges to holes touch. n log n in edges, but for the few of usual faces, all
// of whose pairs are looked at.
bool outline_crosses_itself(const std::vector<glm::dvec2>& points, const std::vector<std::uint32_t>& outline);

}  // namespace crevice
