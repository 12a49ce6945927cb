#include "ssao/rays/bvh.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "ssao/rays/bvh_parts.h"
#include "ssao/rays/bvh_split.h"

namespace crevice {

namespace {

constexpr std::size_t kMaxTriangles = 0x7fffffff;
constexpr std::size_t kLeaf = kBvhWidth;
// Ranges of at most this share of all triangles, or this many, become subtrees built side by side. Neither
// depends on the number of threads, so the order of the nodes does not.
constexpr std::size_t kSubtreeShare = 64;
constexpr std::size_t kSmallSubtree = 2048;

// The parts a node cuts its range into. While there is room the one with the largest box is cut, or the one
// with the most triangles where that decides, or boxes are equal.
std::vector<TriangleRange> children_of(const TriangleRange& range, bool by_area, const Run& run) {
    std::vector<TriangleRange> children = {range};
    const auto rank = [&](const TriangleRange& r) {
        const bool cut = r.triangles.size() > kLeaf;
        return std::tuple(cut, by_area ? r.box.half_area() : 0.0, r.triangles.size());
    };
    while (children.size() < kBvhWidth) {
        const auto next = std::max_element(
            children.begin(), children.end(),
            [&](const TriangleRange& a, const TriangleRange& b) { return rank(a) < rank(b); });
        if (next->triangles.size() <= kLeaf) break;
        auto [left, right] = by_area ? split_by_area(*next, run) : split_in_halves(*next, run);
        *next = left;
        children.push_back(right);
    }
    // The largest last, which rays that go together visit first: what is large is in the way of most of them.
    std::stable_sort(children.begin(), children.end(), [](const TriangleRange& a, const TriangleRange& b) {
        return a.box.half_area() < b.box.half_area();
    });
    return children;
}

// A range that becomes a subtree of its own, and the place in the tree that waits for it.
struct Subtree {
    TriangleRange range;
    int level;
    std::size_t node;
    int place;
};

struct Builder {
    std::span<const Corners> triangles;
    Run run;
    std::size_t subtree_size;  // ranges of at most this many are left for later; 0: none
    std::vector<BvhNode> nodes = {};
    std::vector<BvhBlock> blocks = {};
    std::vector<Subtree> later = {};

    std::int32_t add_block(const TriangleRange& range) {
        BvhBlock block;
        for (std::size_t lane = 0; lane < kBvhWidth; ++lane) {
            const BoxedTriangle& boxed = range.triangles[lane < range.triangles.size() ? lane : 0];
            const Corners& corners = triangles[static_cast<std::size_t>(boxed.triangle)];
            for (std::size_t c = 0; c < 3; ++c) {
                for (int axis = 0; axis < 3; ++axis) block.corner[c][axis][lane] = corners[c][axis];
            }
            block.triangle[lane] = boxed.triangle;
        }
        blocks.push_back(block);
        return static_cast<std::int32_t>(blocks.size() - 1);
    }

    // Adds the node of a range and all below it. `level` is the number of nodes above.
    std::int32_t add_node(const TriangleRange& range, int level) {
        const std::size_t index = nodes.size();
        nodes.emplace_back();
        const std::vector<TriangleRange> children = children_of(range, level < kSahLevels, run);
        for (std::size_t i = 0; i < kBvhWidth; ++i) {
            const Box box = i < children.size() ? children[i].box : Box();
            for (int axis = 0; axis < 3; ++axis) {
                nodes[index].bounds[2 * axis][i] = box.low[axis];
                nodes[index].bounds[2 * axis + 1][i] = box.high[axis];
            }
            const std::int32_t child = i < children.size() ? add_child(children[i], level, index, i) : 0;
            nodes[index].child[i] = child;
        }
        return static_cast<std::int32_t>(index);
    }

    std::int32_t add_child(const TriangleRange& child, int level, std::size_t parent, std::size_t place) {
        if (child.triangles.size() <= kLeaf) return ~add_block(child);
        if (child.triangles.size() > subtree_size) return add_node(child, level + 1);
        later.push_back({child, level + 1, parent, static_cast<int>(place)});
        return 0;
    }

    // Hangs another builder's tree into the place that waits for it.
    void append(const Builder& other, const Subtree& subtree) {
        const auto first_node = static_cast<std::int32_t>(nodes.size());
        const auto first_block = static_cast<std::int32_t>(blocks.size());
        for (BvhNode node : other.nodes) {
            for (std::int32_t& child : node.child)
                child = child < 0 ? ~(~child + first_block) : child + first_node;
            nodes.push_back(node);
        }
        blocks.insert(blocks.end(), other.blocks.begin(), other.blocks.end());
        nodes[subtree.node].child[subtree.place] = first_node;
    }
};

std::vector<BoxedTriangle> boxed(std::span<const Corners> triangles, const Run& run) {
    constexpr std::size_t kPiece = 4096;
    std::vector<BoxedTriangle> boxes(triangles.size());
    parallel_for(static_cast<int>((triangles.size() + kPiece - 1) / kPiece), run, [&](int piece) {
        const std::size_t first = static_cast<std::size_t>(piece) * kPiece;
        for (std::size_t i = first; i < std::min(first + kPiece, triangles.size()); ++i) {
            const Corners& c = triangles[i];
            boxes[i] = {glm::min(c[0], glm::min(c[1], c[2])), static_cast<std::int32_t>(i),
                        glm::max(c[0], glm::max(c[1], c[2]))};
        }
    });
    return boxes;
}

}  // namespace

Bvh build_bvh(std::span<const Corners> triangles, const Run& run) {
    if (triangles.size() > kMaxTriangles)
        throw UsageError("triangles: more than 2^31 - 1 (" + std::to_string(triangles.size()) +
                         "); leave some out");
    if (triangles.empty()) return {};
    std::vector<BoxedTriangle> whole = boxed(triangles, run);
    const Box box = range_of(whole, run).box;
    std::vector<BoxedTriangle> boxes = boxed_parts(triangles, std::move(whole), box);
    const TriangleRange all = range_of(boxes, run);

    Builder top{triangles, run, std::max(kSmallSubtree, boxes.size() / kSubtreeShare)};
    top.add_node(all, 0);
    Run alone = run;  // a subtree is built by one thread
    alone.threads = 1;
    std::vector<Builder> subtrees(top.later.size(), Builder{triangles, alone, 0});
    parallel_for(static_cast<int>(subtrees.size()), run, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        subtrees[index].add_node(top.later[index].range, top.later[index].level);
    });
    const std::vector<Subtree> places = std::move(top.later);
    for (std::size_t i = 0; i < places.size(); ++i) {
        top.append(subtrees[i], places[i]);
        subtrees[i] = Builder{triangles, alone, 0};  // its memory is free for the next
    }

    Bvh bvh{std::move(top.nodes), std::move(top.blocks), 0};
    const glm::vec3 furthest = glm::max(glm::abs(all.box.low), glm::abs(all.box.high));
    bvh.reach = std::max(furthest.x, std::max(furthest.y, furthest.z));
    return bvh;
}

std::size_t size_bytes(const Bvh& bvh) {
    return bvh.nodes.size() * sizeof(BvhNode) + bvh.blocks.size() * sizeof(BvhBlock);
}

}  // namespace crevice
