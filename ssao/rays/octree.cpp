#include "ssao/rays/octree.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"

namespace crevice {

namespace {

constexpr std::size_t kMostTriangles = std::size_t{1} << 28;
// Rays are handed out in pieces of this many.
constexpr std::size_t kPiece = 1024;
constexpr std::size_t kOctants = 8;
static_assert(kOctants == kBvhWidth);

struct Cube {
    glm::vec3 low, high;
};

// The half of a cube on either side of its middle along each axis; neighbours share their planes to the bit.
Cube octant(const Cube& cube, std::size_t which) {
    Cube part = cube;
    for (int axis = 0; axis < 3; ++axis) {
        const float middle = 0.5f * cube.low[axis] + 0.5f * cube.high[axis];
        ((which >> axis & 1) != 0 ? part.low : part.high)[axis] = middle;
    }
    return part;
}

// Whether a triangle touches a cube, or might: its box does, and its plane. `margin` is how far a hit found
// in double may lie off the triangle.
bool touches(const Corners& corners, const Cube& cube, double margin) {
    const glm::dvec3 a = corners[0], b = corners[1], c = corners[2];
    const glm::dvec3 low = glm::min(a, glm::min(b, c)) - margin, high = glm::max(a, glm::max(b, c)) + margin;
    const glm::dvec3 cube_low = cube.low, cube_high = cube.high;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(low[axis] <= cube_high[axis] && cube_low[axis] <= high[axis])) return false;
    }
    const glm::dvec3 ab = b - a, ac = c - a, n = glm::cross(ab, ac), size = glm::abs(n);
    const glm::dvec3 to_middle = 0.5 * (cube_low + cube_high) - a,
                     half = 0.5 * (cube_high - cube_low) + margin;
    // The normal of a needle is off by up to the rounding of its product, however short it is itself.
    const double rounding =
        0x1p-48 * glm::length(ab) * glm::length(ac) * (glm::length(to_middle) + glm::length(half));
    return std::abs(glm::dot(n, to_middle)) <= glm::dot(size, half) + rounding;
}

// A cube around all triangles. It begins at their lowest corner, so that a scene that is flat along an axis
// lies on its side and not along the planes that cut it.
Cube cube_around(std::span<const Corners> triangles) {
    Cube box = {triangles[0][0], triangles[0][0]};
    for (const Corners& corners : triangles) {
        for (const glm::vec3& p : corners) box = {glm::min(box.low, p), glm::max(box.high, p)};
    }
    const glm::vec3 extent = box.high - box.low;
    const float edge = std::max(extent.x, std::max(extent.y, extent.z));
    return {box.low, glm::max(box.high, box.low + edge)};
}

struct Builder {
    std::span<const Corners> triangles;
    double margin;
    Octree octree = {};

    // What a cut turned into: eight lists of triangles.
    using Parts = std::array<std::vector<std::int32_t>, kOctants>;

    Parts cut(const std::vector<std::int32_t>& list, const Cube& cube) const {
        Parts parts;
        for (std::size_t i = 0; i < kOctants; ++i) {
            const Cube part = octant(cube, i);
            for (const std::int32_t triangle : list) {
                if (touches(triangles[static_cast<std::size_t>(triangle)], part, margin))
                    parts[i].push_back(triangle);
            }
        }
        return parts;
    }

    // `growth` is by how much the cuts above have multiplied the triangles. A cut that would take it beyond
    // kOctreeCopies is not made; then, from the leaves upwards, no cube's leaves hold more than its triangles
    // times kOctreeCopies / growth.
    std::int32_t add(const std::vector<std::int32_t>& list, const Cube& cube, int level, double growth) {
        if (list.size() < kOctreeLeaf || level == kOctreeLevels) return ~add_leaf(list);
        const Parts parts = cut(list, cube);
        std::size_t copies = 0;
        for (const auto& part : parts) copies += part.size();
        growth *= static_cast<double>(copies) / static_cast<double>(list.size());
        if (growth > kOctreeCopies) return ~add_leaf(list);
        return add_node(parts, cube, level, growth);
    }

    std::int32_t add_node(const Parts& parts, const Cube& cube, int level, double growth) {
        const std::size_t index = octree.nodes.size();
        octree.nodes.emplace_back();
        octree.levels = std::max(octree.levels, level + 1);
        for (std::size_t i = 0; i < kOctants; ++i) {
            const Cube part = octant(cube, i);
            set_box(index, i, part, parts[i].empty());
            const std::int32_t child = parts[i].empty() ? 0 : add(parts[i], part, level + 1, growth);
            octree.nodes[index].child[i] = child;
        }
        return static_cast<std::int32_t>(index);
    }

    // An empty place is one that no ray enters; see BvhNode.
    void set_box(std::size_t node, std::size_t place, const Cube& cube, bool empty) {
        for (int axis = 0; axis < 3; ++axis) {
            float* const low = octree.nodes[node].bounds[2 * axis];
            float* const high = octree.nodes[node].bounds[2 * axis + 1];
            low[place] = empty ? std::numeric_limits<float>::infinity() : cube.low[axis];
            high[place] = empty ? -std::numeric_limits<float>::infinity() : cube.high[axis];
        }
    }

    std::int32_t add_leaf(const std::vector<std::int32_t>& list) {
        const auto first = static_cast<std::uint32_t>(octree.blocks.size());
        for (std::size_t i = 0; i < list.size(); i += kBvhWidth) {
            BvhBlock block;
            for (std::size_t lane = 0; lane < kBvhWidth; ++lane) {
                const std::int32_t triangle = list[i + lane < list.size() ? i + lane : i];
                const Corners& corners = triangles[static_cast<std::size_t>(triangle)];
                for (std::size_t c = 0; c < 3; ++c) {
                    for (int axis = 0; axis < 3; ++axis) block.corner[c][axis][lane] = corners[c][axis];
                }
                block.triangle[lane] = triangle;
            }
            octree.blocks.push_back(block);
        }
        octree.copies += list.size();
        octree.leaves.push_back({first, static_cast<std::uint32_t>(octree.blocks.size()) - first});
        return static_cast<std::int32_t>(octree.leaves.size() - 1);
    }

    // The whole tree. Few triangles make a node with one leaf, so that there always is a box to enter.
    void build(const std::vector<std::int32_t>& all, const Cube& cube) {
        if (add(all, cube, 0, 1) >= 0) return;
        octree.nodes.emplace_back();
        for (std::size_t i = 0; i < kOctants; ++i) set_box(0, i, cube, i > 0);
        std::fill_n(octree.nodes[0].child, kOctants, 0);
        octree.nodes[0].child[0] = ~0;
        octree.levels = 1;
    }
};

// The ray must be usable().
template <class F>
CREVICE_INLINE OctreeWalk walk_of(const Octree& octree, const Ray& ray, float max_distance) {
    OctreeWalk found;
    if (octree.nodes.empty()) return found;
    const BoxRay box = box_ray(ray, max_distance, octree.reach);
    // Each node takes itself off and puts eight children on at most.
    std::int32_t waiting[1 + (kOctants - 1) * (kOctreeLevels + 1)];
    int count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::int32_t child = waiting[--count];
        if (child < 0) {
            const OctreeLeaf& leaf = octree.leaves[static_cast<std::size_t>(~child)];
            for (std::uint32_t b = leaf.first_block; b < leaf.first_block + leaf.block_count; ++b) {
                found.triangles += kBvhWidth;
                found.occluded = meets_block<F>(ray, max_distance, octree.blocks[b]);
                if (found.occluded) return found;
            }
            continue;
        }
        const BvhNode& node = octree.nodes[static_cast<std::size_t>(child)];
        alignas(32) float distance[kBvhWidth];
        found.boxes += kBvhWidth;
        for (std::uint32_t entered = entered_children<F>(box, node, distance); entered != 0;
             entered &= entered - 1)
            waiting[count++] = node.child[__builtin_ctz(entered)];
    }
    return found;
}

}  // namespace

Octree build_octree(std::span<const Corners> triangles) {
    if (triangles.size() > kMostTriangles)
        throw UsageError("triangles: more than 2^28 (" + std::to_string(triangles.size()) +
                         "); leave some out");
    if (triangles.empty()) return {};
    const Cube cube = cube_around(triangles);
    const glm::vec3 furthest = glm::max(glm::abs(cube.low), glm::abs(cube.high));
    const float reach = std::max(furthest.x, std::max(furthest.y, furthest.z));
    std::vector<std::int32_t> all(triangles.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
    // Above the error that ray_axis() allows for, 2^-44.
    Builder builder{triangles, 0x1p-40 * static_cast<double>(reach) + 0x1p-126};
    builder.octree.reach = reach;
    builder.build(all, cube);
    return std::move(builder.octree);
}

OccludedRays occluded(const Octree& octree, std::span<const Ray> rays, float max_distance, const Run& run) {
    validate(run);
    require_max_distance(max_distance);
    OccludedRays result{std::vector<std::uint8_t>(rays.size()), 0};
    for (const Ray& ray : rays) result.refused += usable(ray) ? 0 : 1;
    parallel_for(static_cast<int>((rays.size() + kPiece - 1) / kPiece), run, [&](int piece) {
        const std::size_t first = static_cast<std::size_t>(piece) * kPiece;
        run_narrow_kernel(run, [&]<class F>(Lanes<F>) {
            for (std::size_t i = first; i < std::min(first + kPiece, rays.size()); ++i) {
                const bool met = usable(rays[i]) && walk_of<F>(octree, rays[i], max_distance).occluded;
                result.occluded[i] = met ? 1 : 0;
            }
        });
    });
    return result;
}

OctreeWalk walk(const Octree& octree, const Ray& ray, float max_distance) {
    require_max_distance(max_distance);
    if (!usable(ray))
        throw UsageError(
            "ray: direction or origin is not usable (see usable() in ray_triangle.h); leave it "
            "out");
    return walk_of<float>(octree, ray, max_distance);
}

}  // namespace crevice
