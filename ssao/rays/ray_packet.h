// Eight rays at a time through a Bvh: is anything in the way of each?
//
// All eight are tested against one box after the other, so what a node costs is shared: up to 1.4 times as
// fast as one ray after the other (ray_traverse.h) when the rays start together, as all rays of a pixel do,
// and point alike. In a block of triangles each ray goes on alone, so the answers are the same to the bit.
#pragma once

#include <cstdint>
#include <span>

#include "ssao/rays/ray_traverse.h"

namespace crevice {

// So few rays go on one after the other: together they would take longer.
inline constexpr int kFewRays = 2;

// Rays against boxes.
template <class F>
struct BoxPacket {
    RayAxis<F> x, y, z;
    F max_distance;      // boxes beyond it do not matter; negative where there is no ray
    std::uint32_t rays;  // that can be traced, as bits
};

// `rays` holds kLanes<F> or fewer.
template <class F>
CREVICE_INLINE BoxPacket<F> box_packet(std::span<const Ray> rays, float max_distance, float reach) {
    alignas(32) float origin[3][kLanes<F>] = {}, direction[3][kLanes<F>] = {}, limit[kLanes<F>];
    std::uint32_t traced = 0;
    for (std::size_t i = 0; i < kLanes<F>; ++i) {
        limit[i] = -1;
        if (i >= rays.size() || !usable(rays[i])) continue;
        traced |= 1u << i;
        limit[i] = max_distance * kBoxTolerance;
        for (int axis = 0; axis < 3; ++axis) {
            origin[axis][i] = rays[i].origin[axis];
            direction[axis][i] = rays[i].direction[axis];
        }
    }
    const F x = load<F>(origin[0]), y = load<F>(origin[1]), z = load<F>(origin[2]);
    const F furthest = F(reach) + max_of(absolute(x), max_of(absolute(y), absolute(z)));
    return {ray_axis(x, load<F>(direction[0]), furthest), ray_axis(y, load<F>(direction[1]), furthest),
            ray_axis(z, load<F>(direction[2]), furthest), load<F>(limit), traced};
}

template <class F>
CREVICE_INLINE Slab<F> slab(const RayAxis<F>& axis, float low, float high) {
    const F in = select(axis.backwards, F(high), F(low)), out = select(axis.backwards, F(low), F(high));
    return {(in - axis.origin_in) * axis.inverse, (out - axis.origin_out) * axis.inverse};
}

// Which rays enter the box of one child, as bits.
template <class F>
CREVICE_INLINE std::uint32_t entering_rays(const BoxPacket<F>& packet, const BvhNode& node, int child) {
    const Slab<F> x = slab(packet.x, node.bounds[0][child], node.bounds[1][child]),
                  y = slab(packet.y, node.bounds[2][child], node.bounds[3][child]),
                  z = slab(packet.z, node.bounds[4][child], node.bounds[5][child]);
    const F in = max_of(z.in, max_of(y.in, max_of(x.in, F(0))));
    const F out = min_of(z.out, min_of(y.out, min_of(x.out, packet.max_distance)));
    return lane_bits(in <= F(kBoxTolerance) * out);
}

// Which of kLanes<F> rays or fewer meet anything at a distance in (0, max_distance], as bits. Rays that are
// not usable() meet nothing.
template <class F>
CREVICE_INLINE std::uint32_t which_meet_any(const Bvh& bvh, std::span<const Ray> rays, float max_distance) {
    if (bvh.nodes.empty()) return 0;
    const BoxPacket<F> packet = box_packet<F>(rays, max_distance, bvh.reach);
    std::uint32_t met = 0;
    struct Waiting {
        std::int32_t child;
        std::uint32_t rays;  // that enter its box
    };
    // Each node takes itself off and puts eight children on at most: see WaitingChildren.
    Waiting waiting[1 + WaitingChildren::kMost];
    int count = 0;
    waiting[count++] = {0, packet.rays};
    while (count > 0) {
        const Waiting next = waiting[--count];
        std::uint32_t open = next.rays & ~met;
        if (next.child < 0 || __builtin_popcount(open) <= kFewRays) {
            for (; open != 0; open &= open - 1) {
                const int i = __builtin_ctz(open);
                const Ray& ray = rays[static_cast<std::size_t>(i)];
                const bool meets =
                    next.child < 0 ? meets_block<F>(ray, ray_space<float>(ray, max_distance), max_distance,
                                                    bvh.blocks[static_cast<std::size_t>(~next.child)])
                                   : meets_any<F>(bvh, ray, max_distance, next.child);
                if (meets) met |= 1u << i;
            }
            continue;
        }
        const BvhNode& node = bvh.nodes[static_cast<std::size_t>(next.child)];
        for (int child = 0; child < kBvhWidth && node.bounds[0][child] <= node.bounds[1][child]; ++child) {
            const std::uint32_t entering = entering_rays(packet, node, child) & ~met;
            if (entering != 0) waiting[count++] = {node.child[child], entering};
        }
    }
    return met;
}

}  // namespace crevice
