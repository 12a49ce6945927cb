// Rays from one point go through a Bvh together: is anything in the way of each?
//
// What depends on the point alone is found once for all of them: where the boxes of a node lie from it, which no ray can
// reach and which hold it, and how it sees the triangles of a block. Where few are left they go on by themselves
// (single_rays.h). Each is tested against a triangle as ray_traverse.h does, so the answers are the same to the bit.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ssao/rays/ray_packet.h"
#include "ssao/rays/single_rays.h"

namespace crevice {

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
        CREVICE_UNROLLED
        for (int axis = 0; axis < 3; ++axis) {
            const F low = load<F>(node.bounds[2 * axis] + i) - F(packet.from[2 * axis]),
                    high = load<F>(node.bounds[2 * axis + 1] + i) - F(packet.from[2 * axis + 1]);
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
    CREVICE_UNROLLED
    for (int axis = 0; axis < 3; ++axis) {
        const F inverse = load<F>(packet.inverse[axis] + first);
        const F to_low = F(boxes.low[axis][child]) * inverse, to_high = F(boxes.high[axis][child]) * inverse;
        in = max_of(in, min_of(to_low, to_high));
        out = min_of(out, max_of(to_low, to_high));
    }
    return lane_bits(in <= F(kBoxTolerance) * out);
}

// Which of `rays` meet a triangle of a block.
//
// Most that float cannot tell is about the triangle that the rays start on, which each of them seems to pass through, before
// or behind. Double tells it once for all of them.
template <class F>
CREVICE_INLINE std::uint64_t meeting_block(const RayPacket& packet, std::uint64_t rays,
                                           const BvhBlock& block) {
    std::uint64_t met = 0;
    for (int lane = 0; lane < kBvhWidth; lane += kLanes<F>) {
        SeenTriangles<F> seen = seen_triangles<F>(packet.origin, block, lane);
        std::uint32_t in_double = 0;  // as bits: lanes whose volumes are double's
        std::uint64_t left = rays & ~met;
        while (left != 0) {
            const Ray ray = packet.ray(__builtin_ctzll(left));
            const Verdict<F> found = verdict(seen, spread<F>(ray_aim(ray.direction, packet.max_distance)));
            const std::uint32_t perhaps = lane_bits(found.perhaps), in_float = perhaps & ~in_double;
            if (in_float != 0 && !any(found.sure)) {
                seen = with_volumes_in_double(seen, packet.origin, block, lane, in_float);
                in_double |= in_float;
                continue;  // the same ray again
            }
            if (perhaps != 0 &&
                (any(found.sure) || meets_one_of(ray, packet.max_distance, block, perhaps << lane)))
                met |= left & -left;
            left &= left - 1;
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
    for (std::uint32_t left = boxes.reached & ~boxes.around; left != 0; left &= left - 1) {
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
    SingleRays singles;
    int single_count = 0;
    const int few = std::min(kFewRays, (__builtin_popcountll(packet.rays) + 1) / 2);
    while (count > 0 || single_count > 0) {
        if (count == 0 || single_count >= kSinglesTogether) {
            met = which_singles_meet_any<F>(bvh, packet, met, singles, single_count);
            single_count = 0;
            continue;
        }
        const Waiting next = waiting[--count];
        std::uint64_t open = next.rays & ~met;
        if (next.child < 0) {
            if (open != 0)
                met |= meeting_block<F>(packet, open, bvh.blocks[static_cast<std::size_t>(~next.child)]);
        } else if (__builtin_popcountll(open) <= few) {
            for (; open != 0; open &= open - 1)
                singles.push_if(true, next.child, __builtin_ctzll(open), single_count);
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

// Calls body(i) for each ray that meets anything at a distance in (0, max_distance], in their order. Returns how many
// rays are not usable(); those meet nothing.
template <class F, class Body>
CREVICE_INLINE std::size_t for_meeting_rays(const Bvh& bvh, std::span<const Ray> rays, float max_distance,
                                            const Body& body) {
    std::size_t first = 0, refused = 0;
    while (first < rays.size()) {
        const std::span<const Ray> left = rays.subspan(first), together = left.first(packet_size(left));
        std::uint64_t met = 0;  // as bits
        if (together.size() > 1) {
            const RayPacket packet = ray_packet<F>(together, max_distance, bvh.reach);
            met = which_meet_any<F>(bvh, packet);
            refused += together.size() - static_cast<std::size_t>(__builtin_popcountll(packet.rays));
        } else if (usable(left[0])) {
            met = meets_any<F>(bvh, left[0], max_distance) ? 1 : 0;
        } else {
            ++refused;
        }
        // In one place, because it is inlined and may cast rays itself.
        for (; met != 0; met &= met - 1) body(first + static_cast<std::size_t>(__builtin_ctzll(met)));
        first += together.size();
    }
    return refused;
}

}  // namespace crevice
