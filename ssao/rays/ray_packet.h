// Rays from one point go through a Bvh together: is anything in the way of each?
//
// What depends on the point alone is found once for all of them: where the boxes of a node lie from it, which no ray can
// reach and which hold it, and how it sees the triangles of a block. Then each ray is tested as ray_traverse.h does, so the
// answers are the same to the bit.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "ssao/rays/ray_traverse.h"

namespace crevice {

// So many rays at most, one a bit.
inline constexpr int kPacketRays = 64;
// So few rays go on one after the other: together they would take longer.
inline constexpr int kFewRays = 4;
// So many rays for each box, or fewer, are tested one by one against all boxes of a node, more of them box by box.
inline constexpr int kRaysABox = 2;

// Rays that start in one point.
struct RayPacket {
    glm::vec3 origin{0};
    std::uint64_t rays = 0;  // that can be traced
    float max_distance = 0;
    float box_distance = 0;  // boxes beyond it do not matter
    // Where the lowest and the highest planes of boxes are seen from: box_margin() apart from the origin.
    float from_low[3] = {}, from_high[3] = {};
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
        packet.from_low[axis] = packet.origin[axis] + margin;
        packet.from_high[axis] = packet.origin[axis] - margin;
        float high[kLanes<F>], low[kLanes<F>];
        store(high, highest_d[axis]);
        store(low, lowest_d[axis]);
        packet.soonest_up[axis] = min_of(1 / *std::max_element(high, high + kLanes<F>), kLargest);
        packet.soonest_down[axis] = min_of(1 / std::abs(*std::min_element(low, low + kLanes<F>)), kLargest);
    }
    return packet;
}

// The boxes of a node's children as the rays of a packet see them.
struct BoxesFromPoint {
    alignas(32) float low[3][kBvhWidth], high[3][kBvhWidth];
    std::uint32_t reached = 0;  // as bits: a ray may enter
    std::uint32_t around = 0;   // as bits: the point is inside, so every ray does
};

template <class F>
CREVICE_INLINE BoxesFromPoint boxes_from_point(const RayPacket& packet, const BvhNode& node) {
    BoxesFromPoint boxes;
    for (int i = 0; i < kBvhWidth; i += kLanes<F>) {
        F soonest = F(0), outside = F(-1);
        for (int axis = 0; axis < 3; ++axis) {
            const F low = load<F>(node.bounds[2 * axis] + i) - F(packet.from_low[axis]),
                    high = load<F>(node.bounds[2 * axis + 1] + i) - F(packet.from_high[axis]);
            store(boxes.low[axis] + i, low);
            store(boxes.high[axis] + i, high);
            outside = max_of(outside, max_of(low, -high));
            soonest = max_of(soonest,
                             max_of(low * F(packet.soonest_up[axis]), -high * F(packet.soonest_down[axis])));
        }
        boxes.reached |= lane_bits(soonest <= F(kBoxTolerance * packet.box_distance)) << i;
        boxes.around |= lane_bits(outside <= F(0)) << i;
    }
    return boxes;
}

// Which rays enter the box of one child, of the kLanes<F> from `first` on, as bits.
template <class F>
CREVICE_INLINE std::uint32_t entering_rays(const RayPacket& packet, const BoxesFromPoint& boxes, int child,
                                           int first) {
    F in = F(0), out = F(packet.box_distance);
    for (int axis = 0; axis < 3; ++axis) {
        const F inverse = load<F>(packet.inverse[axis] + first);
        const F to_low = F(boxes.low[axis][child]) * inverse, to_high = F(boxes.high[axis][child]) * inverse;
        in = max_of(in, min_of(to_low, to_high));
        out = min_of(out, max_of(to_low, to_high));
    }
    return lane_bits(in <= F(kBoxTolerance) * out);
}

// Which children's boxes ray `i` enters, as bits.
template <class F>
CREVICE_INLINE std::uint32_t entered_boxes(const RayPacket& packet, const BoxesFromPoint& boxes, int i) {
    std::uint32_t entered = 0;
    for (int child = 0; child < kBvhWidth; child += kLanes<F>) {
        F in = F(0), out = F(packet.box_distance);
        for (int axis = 0; axis < 3; ++axis) {
            const float inverse = packet.inverse[axis][i];
            const float *near = boxes.low[axis], *far = boxes.high[axis];
            if (inverse < 0) std::swap(near, far);
            in = max_of(in, load<F>(near + child) * F(inverse));
            out = min_of(out, load<F>(far + child) * F(inverse));
        }
        entered |= lane_bits(in <= F(kBoxTolerance) * out) << child;
    }
    return entered;
}

// Which of `rays` meet a triangle of a block.
template <class F>
CREVICE_INLINE std::uint64_t meeting_block(const RayPacket& packet, std::uint64_t rays,
                                           const BvhBlock& block) {
    std::uint64_t met = 0;
    for (int lane = 0; lane < kBvhWidth; lane += kLanes<F>) {
        const SeenTriangles<F> seen = seen_triangles<F>(packet.origin, block, lane);
        for (std::uint64_t left = rays & ~met; left != 0; left &= left - 1) {
            const Ray ray = packet.ray(__builtin_ctzll(left));
            const Verdict<F> found = verdict(seen, spread<F>(ray_aim(ray.direction, packet.max_distance)));
            const std::uint32_t perhaps = lane_bits(found.perhaps) << lane;
            if (perhaps == 0) continue;
            if (any(found.sure) || meets_one_of(ray, packet.max_distance, block, perhaps))
                met |= left & -left;
        }
    }
    return met;
}

// Which of `open` enter the box of each child.
template <class F>
CREVICE_INLINE void enter_boxes(const RayPacket& packet, const BoxesFromPoint& boxes, std::uint64_t open,
                                std::uint64_t (&entering)[kBvhWidth]) {
    constexpr std::uint64_t kLaneBits = (std::uint64_t{2} << (kLanes<F> - 1)) - 1;
    for (std::uint32_t around = boxes.around; around != 0; around &= around - 1)
        entering[__builtin_ctz(around)] = open;
    const std::uint32_t tested = boxes.reached & ~boxes.around;
    if (__builtin_popcountll(open) <= kRaysABox * __builtin_popcount(tested)) {
        for (std::uint64_t left = open; left != 0; left &= left - 1) {
            std::uint32_t entered = entered_boxes<F>(packet, boxes, __builtin_ctzll(left)) & tested;
            for (; entered != 0; entered &= entered - 1) entering[__builtin_ctz(entered)] |= left & -left;
        }
        return;
    }
    for (std::uint32_t left = tested; left != 0; left &= left - 1) {
        const int child = __builtin_ctz(left);
        for (int first = 0; first < kPacketRays; first += kLanes<F>) {
            const std::uint64_t lanes = open & kLaneBits << first;
            if (lanes == 0) continue;
            const std::uint64_t entered = entering_rays<F>(packet, boxes, child, first);
            entering[child] |= entered << first & lanes;
        }
    }
}

// Which rays meet anything at a distance in (0, max_distance], as bits.
template <class F>
CREVICE_INLINE std::uint64_t which_meet_any(const Bvh& bvh, const RayPacket& packet) {
    if (bvh.nodes.empty()) return 0;
    std::uint64_t met = 0;
    struct Waiting {
        std::int32_t child;
        std::uint64_t rays;  // that enter its box
    };
    // Each node takes itself off and puts eight children on at most: see WaitingChildren.
    Waiting waiting[1 + WaitingChildren::kMost];
    int count = 0;
    waiting[count++] = {0, packet.rays};
    while (count > 0) {
        const Waiting next = waiting[--count];
        std::uint64_t open = next.rays & ~met;
        if (next.child < 0) {
            if (open != 0)
                met |= meeting_block<F>(packet, open, bvh.blocks[static_cast<std::size_t>(~next.child)]);
        } else if (__builtin_popcountll(open) <= kFewRays) {
            for (; open != 0; open &= open - 1) {
                const Ray ray = packet.ray(__builtin_ctzll(open));
                if (meets_any<F>(bvh, ray, packet.max_distance, next.child)) met |= open & -open;
            }
        } else {
            const BvhNode& node = bvh.nodes[static_cast<std::size_t>(next.child)];
            std::uint64_t entering[kBvhWidth] = {};
            enter_boxes<F>(packet, boxes_from_point<F>(packet, node), open, entering);
            for (int child = 0; child < kBvhWidth; ++child) {
                if (entering[child] != 0) waiting[count++] = {node.child[child], entering[child]};
            }
        }
    }
    return met;
}

// How many of the first rays, kPacketRays at most, start in the same point.
inline std::size_t packet_size(std::span<const Ray> rays) {
    const std::size_t most = std::min<std::size_t>(kPacketRays, rays.size());
    std::size_t count = 1;
    while (count < most && rays[count].origin == rays[0].origin) ++count;
    return count;
}

// Calls body(i) for each ray that meets anything at a distance in (0, max_distance], in their order. Returns how many
// rays are not usable(); those meet nothing.
template <class F, class Body>
CREVICE_INLINE std::size_t for_meeting_rays(const Bvh& bvh, std::span<const Ray> rays, float max_distance,
                                            const Body& body) {
    std::size_t first = 0, refused = 0;
    while (first < rays.size()) {
        const std::span<const Ray> left = rays.subspan(first), together = left.first(packet_size(left));
        const RayPacket packet = ray_packet<F>(together, max_distance, bvh.reach);
        std::uint64_t met = which_meet_any<F>(bvh, packet);
        for (; met != 0; met &= met - 1) body(first + static_cast<std::size_t>(__builtin_ctzll(met)));
        refused += together.size() - static_cast<std::size_t>(__builtin_popcountll(packet.rays));
        first += together.size();
    }
    return refused;
}

}  // namespace crevice
