// A tree of boxes around triangles, eight children a node, so that one Wide<8> tests them all against a ray.
// Source: Wald 2007, "On fast construction of SAH-based bounding volume hierarchies" (binned surface area
//         heuristic); Dammertz, Hanika & Keller 2008 and Wald, Benthin & Boulos 2008 (wide nodes).
// In:     triangles with finite corners, at most 2^31 - 1 of them
// Out:    Bvh; the same one at every thread count. Each triangle is in one block, but slivers whose boxes overlap
//         too much are in a block for each of their parts (bvh_parts.h)
// Differs from the papers: the wide nodes are split directly, largest box first; every leaf is one block of
//         up to eight triangles; deeper than kSahLevels a range is cut into equal parts, which bounds the
//         depth.
// Cost:   about n log n; 10 million triangles in 5 s. The tree keeps about 50 bytes a triangle or part, and while
//         it is built up to 80 more are in use (32 for boxes, the subtrees twice).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/base/run.h"

namespace crevice {

inline constexpr int kBvhWidth = 8;

// The corners of a triangle, in the order of its mesh.
using Corners = std::array<glm::vec3, 3>;

// Bounds of child i: bounds[2 * axis][i] the lowest, bounds[2 * axis + 1][i] the highest coordinate. Small boxes come
// before large ones. A place without a child has its lowest at +inf and its highest at -inf: no ray enters it.
struct alignas(32) BvhNode {
    float bounds[6][kBvhWidth];
    std::int32_t child[kBvhWidth];  // >= 0: index of a node; < 0: ~index of a block
};

// Up to eight triangles. Lanes without one repeat the first, which changes no answer.
struct alignas(32) BvhBlock {
    float corner[3][3][kBvhWidth];     // corner, axis, lane
    std::int32_t triangle[kBvhWidth];  // index into the triangles that the tree was built of
};

struct Bvh {
    std::vector<BvhNode> nodes;  // the root first; empty without triangles
    std::vector<BvhBlock> blocks;
    float reach = 0;  // the largest absolute coordinate of any corner
};

// No path from the root to a block has more nodes. A range of n <= 2^31 triangles is split by area for
// kSahLevels nodes at most. From there on each child of a node holds at most ceil(n / 8) triangles, so after
// ten such nodes at most 2^31 / 8^10 = 2 are left, which is a leaf.
inline constexpr int kSahLevels = 24;
inline constexpr int kBvhMaxDepth = kSahLevels + 10;

// Throws UsageError when there are more than 2^31 - 1 triangles.
Bvh build_bvh(std::span<const Corners> triangles, const Run& run = {});

// Bytes held by the tree.
std::size_t size_bytes(const Bvh& bvh);

}  // namespace crevice
