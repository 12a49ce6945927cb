// Charts: connected groups of triangles that face about the same way, each laid flat without overlap.
// In:    triangles with welded corners, in double, any one unit of length
// Out:   every triangle in exactly one chart; flat coordinates in the same unit, neither mirrored nor folded
// How:   a chart grows from its first triangle over shared edges to those whose normals lie within
//        kConeCosine of that one's, so none of them is seen at more than twice that angle along the mean
//        normal, which it is laid flat along: no triangle is flipped, none shrinks to less than half its
//        area. Connected triangles can still come to lie on one another (a spiral ramp): they are laid down
//        one after the other, and one that would overlap those that lie there already is left to a later
//        chart.
// Cost:  about 1 microsecond a triangle; long thin triangles in large charts cost more.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace crevice {

// cos 30 degrees.
inline constexpr double kConeCosine = 0.86602540378443864676;

struct WeldedTriangle {
    std::array<glm::dvec3, 3> corners;
    std::array<std::uint32_t, 3> points;  // equal where triangles are connected
    glm::dvec3 normal;                    // unit, cross(corners[1] - corners[0], corners[2] - corners[0])
    double area;                          // > 0
};

struct FlatTriangle {
    std::uint32_t triangle;             // index into the input
    std::array<glm::dvec2, 3> corners;  // in [0, extent]; cross(corners[1] - corners[0], ...) > 0
};
struct FlatChart {
    std::vector<FlatTriangle> triangles;
    glm::dvec2 extent;  // of the bounding rectangle; x is the longer side
};

// In the order of their first triangles; no random choice.
std::vector<FlatChart> grow_charts(std::span<const WeldedTriangle> triangles);

}  // namespace crevice
