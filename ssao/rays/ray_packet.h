// Rays that start in one point, and what is found once for all boxes that they are tested against. packet_traverse.h takes
// them through a Bvh together, single_rays.h those that no others go with.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <glm/vec3.hpp>

#include "ssao/rays/ray_traverse.h"

namespace crevice {

// So many rays at most, one a bit.
inline constexpr int kPacketRays = 64;

// Rays that start in one point.
struct RayPacket {
    glm::vec3 origin{0};
    std::uint64_t rays = 0;  // that can be traced
    float max_distance = 0;
    float box_distance = 0;  // boxes beyond it do not matter
    // Where the planes of BvhNode::bounds are seen from: box_margin() apart from the origin.
    float from[6] = {};
    // No ray gets on by one unit along an axis, or against it, within a shorter distance.
    float soonest_up[3] = {}, soonest_down[3] = {};
    // Lanes without a ray have the direction 0.
    alignas(32) float direction[3][kPacketRays];
    // 1 / direction, but finite, so that no product is 0 * inf. The largest float takes a ray from the margin around a box
    // to further than any hit.
    alignas(32) float inverse[3][kPacketRays];

    Ray ray(int i) const { return {origin, {direction[0][i], direction[1][i], direction[2][i]}}; }
};

// `rays` holds kPacketRays or fewer that start in the same point.
template <class F>
CREVICE_INLINE RayPacket ray_packet(std::span<const Ray> rays, float max_distance, float reach) {
    constexpr float kLargest = std::numeric_limits<float>::max();
    RayPacket packet;
    packet.origin = rays[0].origin;
    packet.max_distance = max_distance;
    packet.box_distance = min_of(max_distance * kBoxTolerance, kLongestRay);
    const glm::vec3 o = glm::abs(packet.origin);
    const float furthest = reach + max_of(o.x, max_of(o.y, o.z));
    const bool within = o.x <= kRayReach && o.y <= kRayReach && o.z <= kRayReach;
    const std::size_t count = rays.size(), padded = (count + kLanes<F> - 1) / kLanes<F> * kLanes<F>;
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) packet.direction[axis][i] = rays[i].direction[axis];
    }
    for (std::size_t i = count; i < padded; ++i) {
        for (int axis = 0; axis < 3; ++axis) packet.direction[axis][i] = 0;
    }
    F highest_d[3] = {F(0), F(0), F(0)}, lowest_d[3] = {F(0), F(0), F(0)};
    for (std::size_t i = 0; i < padded; i += kLanes<F>) {
        F size = F(0);
        auto in_reach = F(0) <= F(within ? 0.0f : -1.0f);
        for (int axis = 0; axis < 3; ++axis) {
            const F d = load<F>(packet.direction[axis] + i);
            in_reach = in_reach & (absolute(d) <= F(kRayReach));
            size = max_of(absolute(d), size);
            highest_d[axis] = max_of(d, highest_d[axis]);
            lowest_d[axis] = min_of(d, lowest_d[axis]);
            store(packet.inverse[axis] + i, max_of(min_of(F(1) / d, F(kLargest)), F(-kLargest)));
        }
        const std::uint64_t traced = lane_bits(in_reach & (size >= F(1 / kRayReach)));
        packet.rays |= traced << i;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const float margin = box_margin(packet.origin[axis], furthest);
        packet.from[2 * axis] = packet.origin[axis] + margin;
        packet.from[2 * axis + 1] = packet.origin[axis] - margin;
        float high[kLanes<F>], low[kLanes<F>];
        store(high, highest_d[axis]);
        store(low, lowest_d[axis]);
        packet.soonest_up[axis] = min_of(1 / *std::max_element(high, high + kLanes<F>), kLargest);
        packet.soonest_down[axis] = min_of(1 / std::abs(*std::min_element(low, low + kLanes<F>)), kLargest);
    }
    return packet;
}

// How many of the first rays, kPacketRays at most, start in the same point.
inline std::size_t packet_size(std::span<const Ray> rays) {
    const std::size_t most = std::min<std::size_t>(kPacketRays, rays.size());
    std::size_t count = 1;
    while (count < most && rays[count].origin == rays[0].origin) ++count;
    return count;
}

}  // namespace crevice
