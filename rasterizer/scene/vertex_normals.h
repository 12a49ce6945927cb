// Vertex normals for meshes that come without.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/base/run.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

// From this crease angle on nothing is a crease.
inline constexpr double kSmoothEverywhere_rad = kPi;

struct CornerNormals {
    std::vector<glm::vec3> normals;                         // unit
    std::vector<std::array<std::uint32_t, 3>> of_triangle;  // indices into `normals`, one a corner
};

// The normal at each corner is the sum of the unit normals of the triangles that share its position, each
// weighted by its angle there (Thuermer & Wuethrich 1998, "Computing vertex normals from polygonal facets"):
// how a face is cut into triangles makes no difference. Triangles share a position when they share its index,
// so texture seams leave no crease. Only triangles whose normal is within crease_angle_rad, in [0, pi], of
// the corner's own take part: less than pi keeps edges sharp. A corner whose sum cancels out (two sides of
// one sheet) has the normal of its triangle. `triangles` index `positions` and are counter-clockwise for
// right-handed axes; one without area has no say and gets (0, 0, 1). `groups`, one a triangle if given, are
// smoothing groups: only triangles of one group smooth each other. Throws UsageError for an angle out of
// range. At pi the cost is linear; below, n triangles at one position take about n^1.5 steps where they face every
// way, n log n where they make a fan.
CornerNormals angle_weighted_normals(std::span<const glm::vec3> positions,
                                     std::span<const std::array<std::uint32_t, 3>> triangles,
                                     double crease_angle_rad, std::span<const std::uint32_t> groups = {},
                                     const Run& run = {});

}  // namespace crevice
