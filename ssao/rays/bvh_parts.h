// Slivers cut into parts for a Bvh. The box of a long thin triangle that runs askew to the axes holds the triangle
// and much else; where thousands meet, as in a fan round one vertex, every ray would enter all their boxes.
// Source: Ernst & Greiner 2007, "Early split clipping for bounding volume hierarchies": a triangle is listed once
//         for each part of it, with the part's box, and tested whole.
// In:     the triangles and their boxes
// Out:    the boxes of all triangles, or of their parts; those of a triangle's parts together hold it. As they
//         were when the boxes overlap little: kOverlap
// Differs from the paper: all slivers are cut equally fine, no finer than it takes to overlap little and no finer
//         than kMostParts allows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ssao/rays/bvh.h"
#include "ssao/rays/bvh_split.h"

namespace crevice {

// A ray through the box of a scene enters the boxes of this many triangles on average (the sum of their surface
// areas over that of the scene's) before slivers are cut.
inline constexpr double kOverlap = 64;
// The surface of a sliver's box is at least this multiple of both its sides: 3.5 for an equilateral triangle askew.
inline constexpr double kSliver = 8;
// So many parts are added at most, or as many as there are triangles if those are more.
inline constexpr std::size_t kMostParts = std::size_t{1} << 20;

// `box` is around all of `boxes`, which hold one box a triangle.
std::vector<BoxedTriangle> boxed_parts(std::span<const Corners> triangles, std::vector<BoxedTriangle> boxes,
                                       const Box& box);

}  // namespace crevice
