#include "ssao/rays/bvh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include <doctest/doctest.h>

#include "tests/tools/ray_checks.h"

using namespace crevice;

namespace {

struct TriangleSet {
    std::string name;
    std::vector<Corners> triangles;
};

std::vector<TriangleSet> triangle_sets() {
    const Corners one = random_triangles(1, 1, 7)[0];
    return {{"one", {one}},
            {"eight", random_triangles(8, 0.2f, 1)},
            {"nine", random_triangles(9, 0.2f, 2)},
            {"many", random_triangles(20000, 0.02f, 3)},
            {"large and overlapping", random_triangles(500, 3, 4)},
            {"thin", thin_triangles(1000, 5)},
            {"shrinking", shrinking_triangles(56)},
            {"equal", std::vector<Corners>(5000, one)},
            {"in one point's row", [] {
                 std::vector<Corners> triangles;
                 for (int i = 0; i < 300; ++i)  // all centres on one line, most of them in one place
                     triangles.push_back({glm::vec3(0, 0, i < 290 ? 0 : i), {1, 0, 0}, {0, 1, 0}});
                 return triangles;
             }()}};
}

bool contains(const BvhNode& node, std::size_t place, const glm::vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(node.bounds[2 * axis][place] <= p[axis] && p[axis] <= node.bounds[2 * axis + 1][place]))
            return false;
    }
    return true;
}

// What is found on a walk through the whole tree.
struct Walk {
    const Bvh& bvh;
    const std::vector<Corners>& triangles;
    int depth = 0;                        // nodes on the longest path
    std::multiset<std::int32_t> found{};  // triangles, once for each block they are in
    std::size_t corners_outside = 0;      // of a box above them
    std::size_t nodes = 0, entered_empty_places = 0;

    void walk(std::int32_t index, std::vector<std::pair<const BvhNode*, std::size_t>>& above) {
        const BvhNode& node = bvh.nodes[static_cast<std::size_t>(index)];
        ++nodes;
        depth = std::max(depth, static_cast<int>(above.size()) + 1);
        for (std::size_t place = 0; place < kBvhWidth; ++place) {
            if (node.bounds[0][place] == std::numeric_limits<float>::infinity()) {
                for (int axis = 0; axis < 3; ++axis)
                    entered_empty_places +=
                        !(node.bounds[2 * axis][place] > node.bounds[2 * axis + 1][place]);
                continue;
            }
            above.emplace_back(&node, place);
            if (node.child[place] >= 0) {
                walk(node.child[place], above);
            } else {
                look_at(bvh.blocks[static_cast<std::size_t>(~node.child[place])], above);
            }
            above.pop_back();
        }
    }

    void look_at(const BvhBlock& block, const std::vector<std::pair<const BvhNode*, std::size_t>>& above) {
        const std::set<std::int32_t> here(std::begin(block.triangle), std::end(block.triangle));
        found.insert(here.begin(), here.end());
        for (std::size_t lane = 0; lane < kBvhWidth; ++lane) {
            const Corners& corners = triangles[static_cast<std::size_t>(block.triangle[lane])];
            for (std::size_t c = 0; c < 3; ++c) {
                for (int axis = 0; axis < 3; ++axis)
                    corners_outside += block.corner[c][axis][lane] != corners[c][axis];
                for (const auto& [node, place] : above)
                    corners_outside += !contains(*node, place, corners[c]);
            }
        }
    }
};

}  // namespace

TEST_CASE("every triangle is in one block, inside all boxes above it, at a bounded depth") {
    for (const TriangleSet& set : triangle_sets()) {
        CAPTURE(set.name);
        const Bvh bvh = build_bvh(set.triangles);
        Walk walk{bvh, set.triangles};
        std::vector<std::pair<const BvhNode*, std::size_t>> above;
        walk.walk(0, above);
        CHECK(walk.nodes == bvh.nodes.size());
        CHECK(walk.entered_empty_places == 0);
        CHECK(walk.corners_outside == 0);
        CHECK(walk.depth <= kBvhMaxDepth);
        REQUIRE(walk.found.size() == set.triangles.size());
        CHECK(*walk.found.begin() == 0);
        CHECK(*walk.found.rbegin() == static_cast<std::int32_t>(set.triangles.size()) - 1);
        CHECK(std::adjacent_find(walk.found.begin(), walk.found.end()) == walk.found.end());
    }
}

TEST_CASE("slivers that are cut into parts are each in a block for every part, at a bounded depth") {
    const TriangleSet sets[] = {{"thin", thin_triangles(3000, 5)}, {"fan", fan_triangles(3000, 0.3f)}};
    for (const TriangleSet& set : sets) {
        CAPTURE(set.name);
        const Bvh bvh = build_bvh(set.triangles);
        Walk walk{bvh, set.triangles};
        std::vector<std::pair<const BvhNode*, std::size_t>> above;
        walk.walk(0, above);
        CHECK(walk.nodes == bvh.nodes.size());
        CHECK(walk.depth <= kBvhMaxDepth);
        CHECK(walk.found.size() > set.triangles.size());
        CHECK(std::set<std::int32_t>(walk.found.begin(), walk.found.end()).size() == set.triangles.size());
    }
}

TEST_CASE("equal triangles are cut in equal parts") {
    const Bvh bvh = build_bvh(std::vector<Corners>(4096, random_triangles(1, 1, 7)[0]));
    CHECK(bvh.blocks.size() == 512);
    CHECK(bvh.nodes.size() == 1 + 8 + 64);
}

TEST_CASE("no triangles make a tree without nodes") {
    const Bvh bvh = build_bvh({});
    CHECK(bvh.nodes.empty());
    CHECK(bvh.blocks.empty());
    CHECK(size_bytes(bvh) == 0);
}

TEST_CASE("the tree is the same at every thread count") {
    // Enough for ranges that are binned in pieces, and for subtrees.
    const std::vector<Corners> triangles = random_triangles(150000, 0.01f, 8);
    Run run;
    run.threads = 1;
    const Bvh one = build_bvh(triangles, run);
    for (const int threads : {2, 3, 7}) {
        CAPTURE(threads);
        run.threads = threads;
        const Bvh bvh = build_bvh(triangles, run);
        REQUIRE(bvh.nodes.size() == one.nodes.size());
        REQUIRE(bvh.blocks.size() == one.blocks.size());
        CHECK(std::memcmp(bvh.nodes.data(), one.nodes.data(), one.nodes.size() * sizeof(BvhNode)) == 0);
        CHECK(std::memcmp(bvh.blocks.data(), one.blocks.data(), one.blocks.size() * sizeof(BvhBlock)) == 0);
    }
}

TEST_CASE("the tree takes at most 100 bytes a triangle") {
    const std::vector<Corners> triangles = random_triangles(20000, 0.02f, 3);
    const Bvh bvh = build_bvh(triangles);
    CHECK(size_bytes(bvh) < 100 * triangles.size());
    CHECK(size_bytes(bvh) > 36 * triangles.size());  // the corners alone
}
