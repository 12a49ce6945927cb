#include "ssao/rays/open_region.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace crevice {

namespace {

// The region's box with everything in reach of it, and the height that something must rise above to be met.
struct Reached {
    glm::vec3 low, high, normal;
    float height;

    bool overlaps(const glm::vec3& other_low, const glm::vec3& other_high) const {
        return glm::all(glm::lessThanEqual(other_low, high)) &&
               glm::all(glm::greaterThanEqual(other_high, low));
    }
    // Of the corner of a box that lies furthest along the normal.
    bool rises(const glm::vec3& other_low, const glm::vec3& other_high) const {
        float top = 0;
        for (int axis = 0; axis < 3; ++axis)
            top += normal[axis] * (normal[axis] > 0 ? other_high[axis] : other_low[axis]);
        return !(top < height);
    }
};

bool block_may_be_met(const BvhBlock& block, const Reached& reached) {
    for (int lane = 0; lane < kBvhWidth; ++lane) {
        const auto corner = [&](int i) {
            return glm::vec3(block.corner[i][0][lane], block.corner[i][1][lane], block.corner[i][2][lane]);
        };
        const glm::vec3 a = corner(0), b = corner(1), c = corner(2);
        const float top =
            std::max({glm::dot(reached.normal, a), glm::dot(reached.normal, b), glm::dot(reached.normal, c)});
        if (top < reached.height) continue;
        if (reached.overlaps(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)))) return true;
    }
    return false;
}

}  // namespace

void RayRegion::include(const glm::vec3& origin, float lifted) {
    low = glm::min(low, origin);
    high = glm::max(high, origin);
    lowest = std::min(lowest, glm::dot(normal, origin));
    lift = std::min(lift, lifted);
}

bool region_is_open(const Bvh& bvh, const RayRegion& region, float radius) {
    if (bvh.nodes.empty()) return true;
    // Heights are rounded, and so are directions, which may fall by a few 2^-24 of the way: half the lift is far more
    // than both, or nothing is claimed.
    constexpr float kRounding = 0x1p-21f;
    const float largest =
        std::max({-region.low.x, -region.low.y, -region.low.z, region.high.x, region.high.y, region.high.z});
    if (!(region.lift / 2 > kRounding * (largest + radius))) return false;
    const glm::vec3 reach(radius * (1 + kRounding) + kRounding * (largest + radius));
    const Reached reached{region.low - reach, region.high + reach, region.normal,
                          region.lowest - region.lift / 2};
    std::array<std::int32_t, (kBvhWidth - 1) * kBvhMaxDepth + 1> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::int32_t at = waiting[--count];
        if (at < 0) {
            if (block_may_be_met(bvh.blocks[static_cast<std::size_t>(~at)], reached)) return false;
            continue;
        }
        const BvhNode& node = bvh.nodes[static_cast<std::size_t>(at)];
        for (int i = 0; i < kBvhWidth; ++i) {
            const glm::vec3 low(node.bounds[0][i], node.bounds[2][i], node.bounds[4][i]),
                high(node.bounds[1][i], node.bounds[3][i], node.bounds[5][i]);
            if (reached.overlaps(low, high) && reached.rises(low, high)) waiting[count++] = node.child[i];
        }
    }
    return true;
}

}  // namespace crevice
