// Polygons with any number of corners, cut into triangles by clipping ears.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace crevice {

// Faces with more corners are refused by the loader. The worst outlines known take some 0.3 s at so many.
inline constexpr std::size_t kMaxFaceCorners = 65536;

// Newell's normal of a polygon in space: its length is twice the area, its direction the side from which the
// corners run counter-clockwise (right-handed axes). Summed around the first corner, so it does not depend on
// where the polygon stands. Corners must be finite.
glm::dvec3 newell_normal(std::span<const glm::vec3> corners);

struct Triangulation {
    std::vector<std::array<std::uint32_t, 3>> triangles;  // corner numbers, in the sense of the polygon
    bool self_intersecting = false;                       // the outline crosses itself: none is right
};

// Triangulates a polygon seen along the axis nearest to its Newell normal. Concave polygons, collinear and
// repeated corners, and holes joined to the outline by a bridge (two coinciding edges) are covered; for a
// simple polygon every triangle has positive area and the areas add up to that of the polygon. One whose
// outline crosses itself is triangulated somehow and said to be so. Corners must be finite. All signs are
// taken from differences of corners in double, which for coordinates of similar magnitude are exact: neither
// the place nor the scale nor the first corner of the polygon matters. After Meisters 1975 ("Polygons have
// ears"). A triangle is held against the reflex corners in the cells of a grid that it reaches, so that most outlines take
// little more than linear time; O(corners * reflex corners) where all of them lie beside every triangle.
Triangulation ear_clip(std::span<const glm::vec3> corners);

// How to cut a quad in two, seen along its Newell normal.
enum class QuadCut {
    first_third,    // 0 1 2, 0 2 3: every convex quad
    second_fourth,  // 0 1 3, 1 2 3: concave at its second or fourth corner
    neither,        // crosses itself
};
QuadCut quad_cut(const std::array<glm::vec3, 4>& corners);

}  // namespace crevice
