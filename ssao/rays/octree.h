// The tutorials' own way to find what a ray meets: a tree of cubes, each cut into eight halves as wide.
// Source: the octree of Luna's book on Direct3D 11, of which X_Jun and Luna tell in their sections on ray casting: a
//         cube of fewer than 60 triangles is a leaf, a triangle that straddles a plane is in several children.
// In:     triangles with finite corners, |coordinates| <= kRayReach
// Out:    hit or not, the same as of the Bvh and of testing every triangle: boxes are entered as in
//         ray_traverse.h and triangles met as in ray_triangle.h
// Differs from the book: a limit of levels and one of copies, without which sixty triangles that share a
//         corner would be cut for ever; the cubes overlap by the error of a hit, which the book's do not.
// Cost:   a ray takes about three times as long as in the Bvh: it knows no nearest child, and its boxes are
//         empty for the most part. It is here to be compared with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ssao/rays/ray_cast.h"

namespace crevice {

// A cube with fewer triangles is a leaf.
inline constexpr std::size_t kOctreeLeaf = 60;
// The edge of the smallest cube is that of the root times 2^-kOctreeLevels.
inline constexpr int kOctreeLevels = 16;
// The leaves hold each triangle at most this many times, on average.
inline constexpr double kOctreeCopies = 8;

// The triangles of a leaf, eight a block; the last block repeats its first triangle.
struct OctreeLeaf {
    std::uint32_t first_block = 0, block_count = 0;
};

struct Octree {
    // BvhNode::child of a leaf is ~index of `leaves`. The root first; empty without triangles.
    std::vector<BvhNode> nodes;
    std::vector<OctreeLeaf> leaves;
    std::vector<BvhBlock> blocks;
    std::size_t copies = 0;  // triangles in all leaves together
    int levels = 0;          // nodes on the longest way from the root to a leaf
    float reach = 0;         // the largest absolute coordinate of any corner
};

// Always the same tree. Throws UsageError when there are more than 2^28 triangles.
Octree build_octree(std::span<const Corners> triangles);

// As occluded() of a RayScene.
OccludedRays occluded(const Octree& octree, std::span<const Ray> rays, float max_distance,
                      const Run& run = {});

// One ray's way through the tree, to step through.
struct OctreeWalk {
    bool occluded = false;
    int boxes = 0;      // that the ray was tested against
    int triangles = 0;  // likewise, in blocks of eight; copies counted
};
// Throws UsageError as occluded() of one ray does.
OctreeWalk walk(const Octree& octree, const Ray& ray, float max_distance);

}  // namespace crevice
