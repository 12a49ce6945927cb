// Rays of a packet that go on by themselves through a Bvh: is anything in the way of each?
// Source: Tsakok 2009, "Faster incoherent rays: multi-BVH ray stream tracing" (many rays' next nodes on one stack).
// Differs from the paper: a waiting node holds one ray; the nodes of several are tested before any answer is looked at.
//
// The way of one ray is a chain: a node is loaded, its boxes are tested, and a branch that no processor foresees says which
// node is next. Where several rays take turns, the processor works at all of their nodes at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "ssao/rays/ray_packet.h"
#include "ssao/rays/ray_traverse.h"

namespace crevice {

// So few rays, and no more than half of those that started, go on by themselves: together they would take longer.
inline constexpr int kFewRays = 8;
// So many take turns. The boxes that they enter fit into the bits of one word.
inline constexpr int kSinglesTogether = 8;

// Single rays, each with a node or a block whose box it enters; kMost at most, the next on top. How many is a variable of its
// own: beside the arrays it would be kept in memory.
template <int kMost>
struct WaitingSingles {
    // One more than kMost: see push_if().
    std::int32_t place[kMost + 1];  // index of the node or of the block
    std::int32_t ray[kMost + 1];    // which of the packet's

    // Written in any case and counted only if it is meant, so that there is no branch to foresee.
    CREVICE_INLINE void push_if(bool meant, std::int32_t next_place, std::int32_t next_ray, int& count) {
        place[count] = next_place;
        ray[count] = next_ray;
        count += meant ? 1 : 0;
    }
};

// Those that wait for nodes. They are traced as soon as kSinglesTogether wait, to which kFewRays less one may be added at
// once. A turn takes nodes off the top and puts their children on. What lies below these is all of one earlier turn's, or of
// the start, less what was taken off it: 7/8 of what one turn puts on at most. Its highest node is above theirs, so there are
// no more such layers than a path has nodes.
inline constexpr int kMostSingleNodes =
    kSinglesTogether + kFewRays + (kBvhWidth - 1) * kSinglesTogether * kBvhMaxDepth + kSinglesTogether;
using SingleRays = WaitingSingles<kMostSingleNodes>;
// Fewer than kSinglesTogether wait for blocks when a turn of nodes begins.
using SinglesAtBlocks = WaitingSingles<(kBvhWidth + 1) * kSinglesTogether>;

// Which children's boxes a ray enters, as bits.
template <class F>
CREVICE_INLINE std::uint32_t entered_boxes(const RayPacket& packet, const BvhNode& node, int ray) {
    std::uint32_t entered = 0;
    for (int i = 0; i < kBvhWidth; i += kLanes<F>) {
        F in = F(0), out = F(packet.box_distance);
        CREVICE_UNROLLED
        for (int axis = 0; axis < 3; ++axis) {
            const float inverse = packet.inverse[axis][ray];
            const int near = 2 * axis + (inverse < 0 ? 1 : 0), far = near ^ 1;
            in = max_of(in, (load<F>(node.bounds[near] + i) - F(packet.from[near])) * F(inverse));
            out = min_of(out, (load<F>(node.bounds[far] + i) - F(packet.from[far])) * F(inverse));
        }
        entered |= lane_bits(in <= F(kBoxTolerance) * out) << i;
    }
    return entered;
}

// Which children's boxes the `count` rays of a turn enter: kBvhWidth bits for each.
template <class F>
CREVICE_INLINE std::uint64_t entered_in_turn(const Bvh& bvh, const RayPacket& packet,
                                             const WaitingSingles<kSinglesTogether>& turn, int count) {
    std::uint64_t entered = 0;
    for (int i = 0; i < count; ++i) {
        const BvhNode& node = bvh.nodes[static_cast<std::size_t>(turn.place[i])];
        entered |= std::uint64_t{entered_boxes<F>(packet, node, turn.ray[i])} << kBvhWidth * i;
    }
    return entered;
}

// Which of the rays from `first` to before `end` meet a triangle of their blocks, as bits, and those of `met`.
template <class F>
CREVICE_INLINE std::uint64_t meeting_blocks(const Bvh& bvh, const RayPacket& packet, std::uint64_t met,
                                            const SinglesAtBlocks& blocks, int first, int end) {
    for (int i = first; i < end; ++i) {
        const std::uint64_t ray = std::uint64_t{1} << blocks.ray[i];
        if ((met & ray) != 0) continue;
        const BvhBlock& block = bvh.blocks[static_cast<std::size_t>(blocks.place[i])];
        if (meets_block<F>(packet.ray(blocks.ray[i]), packet.max_distance, block)) met |= ray;
    }
    return met;
}

// Traces the `node_count` rays that wait for nodes. Which rays meet anything at a distance in (0, max_distance], as bits, and
// those of `met`, which are not traced any more.
template <class F>
CREVICE_INLINE std::uint64_t which_singles_meet_any(const Bvh& bvh, const RayPacket& packet,
                                                    std::uint64_t met, SingleRays& nodes, int node_count) {
    SinglesAtBlocks blocks;
    int block_count = 0;
    while (node_count > 0 || block_count > 0) {
        if (block_count >= kSinglesTogether || node_count == 0) {
            const int end = block_count;
            block_count = std::max(0, block_count - kSinglesTogether);
            met = meeting_blocks<F>(bvh, packet, met, blocks, block_count, end);
            continue;
        }
        WaitingSingles<kSinglesTogether> turn;
        int count = 0;
        while (count < kSinglesTogether && node_count > 0) {
            --node_count;
            const std::int32_t ray = nodes.ray[node_count];
            turn.push_if((met >> ray & 1) == 0, nodes.place[node_count], ray, count);
        }
        std::uint64_t entered = entered_in_turn<F>(bvh, packet, turn, count);
        for (; entered != 0; entered &= entered - 1) {
            const int bit = __builtin_ctzll(entered), i = bit / kBvhWidth;
            const BvhNode& node = bvh.nodes[static_cast<std::size_t>(turn.place[i])];
            const std::int32_t child = node.child[bit % kBvhWidth];
            nodes.push_if(child >= 0, child, turn.ray[i], node_count);
            blocks.push_if(child < 0, ~child, turn.ray[i], block_count);
        }
    }
    return met;
}

}  // namespace crevice
