// Clipping in homogeneous coordinates (Sutherland & Hodgman 1974), before the division: what is left has w >
// 0, depth in range and screen coordinates that fit the fixed-point setup. Only triangles that cross one of
// these planes come here; the edges of the viewport itself never clip.
#pragma once

#include <array>
#include <span>

#include <glm/vec4.hpp>

#include "rasterizer/base/image.h"
#include "rasterizer/draw/vertex_transform.h"

namespace crevice {

// Near, far, the eye plane and the four sides of the guard band.
inline constexpr int kClipPlanes = 7;
inline constexpr int kMaxClippedVertices = 3 + kClipPlanes;
// Vertices nearer to the eye plane are cut off where the range of depths is not one of w.
inline constexpr double kSmallestW = 1e-12;

struct ClippedVertex {
    glm::dvec4 p_clip;
    double lambda1, lambda2;  // barycentric coordinates for vertices 1 and 2 of the triangle that was clipped
    int original;             // 0..2: this vertex was not moved; -1: it lies on a clip plane
};

struct ClippedPolygon {
    std::array<ClippedVertex, kMaxClippedVertices> vertices;
    int count = 0;  // 0, or 3 and more; convex, in the triangle's order
};

// The part of a triangle inside all planes; near and far are those of `range`. A vertex on a plane counts as inside. Two
// triangles that share an edge get the same new vertices on it, to the bit.
ClippedPolygon clip_triangle(const std::array<glm::dvec4, 3>& p_clip, Size size,
                             const DepthRange& range = {});

// Where a new vertex falls on the screen.
ProjectedVertex project_clipped(const ClippedVertex& vertex, Size size);

}  // namespace crevice
