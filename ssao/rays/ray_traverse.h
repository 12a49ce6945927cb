// A ray's way through a Bvh: one ray against eight boxes, then eight triangles, nearest first.
//
// No triangle that the test of ray_triangle.h accepts is ever passed by: the boxes are entered with the error
// of their own arithmetic allowed for (Ize 2013, "Robust BVH ray traversal", JCGT 2(2)). So the order of the
// tree never shows in an answer.
//
// For kernels: inside a lambda of run_kernel() these trace without a call. Others use ray_cast.h.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "rasterizer/lanes/wide.h"
#include "ssao/rays/bvh.h"
#include "ssao/rays/ray_triangle.h"

namespace crevice {

// A box is kept up to this share further than its arithmetic says: three roundings of 2^-24 on either side of
// a comparison, and one of the distance found in it.
inline constexpr float kBoxTolerance = 1 + 0x1p-20f;

// A ray against the planes of one axis. A plane at b is met at distance (b - origin) * inverse, with an origin that is moved
// back for the planes the ray enters a box by, and forth for those it leaves by.
struct RayAxis {
    float origin_in, origin_out;
    float inverse;   // 1 / direction
    bool backwards;  // the ray enters a box by its highest coordinate
};

// Double's own error, less than 2^-44 of the furthest corner, moves a hit off its box at most that far; and less than a
// float's rounding would round back to the origin. `reach` is Bvh::reach plus the largest absolute coordinate of the
// origin.
inline float box_margin(float origin, float reach) {
    return std::abs(origin) * 0x1p-22f + reach * 0x1p-40f + 0x1p-126f;
}

inline RayAxis ray_axis(float origin, float direction, float reach) {
    const float margin = box_margin(origin, reach);
    const bool backwards = std::signbit(direction);  // of -0 too: its inverse is -inf
    const float forward = backwards ? -margin : margin;
    return {origin + forward, origin - forward, 1 / direction, backwards};
}

// One ray against boxes.
struct BoxRay {
    RayAxis x, y, z;
    std::int32_t in_x, in_y, in_z;  // which BvhNode::bounds the ray enters by; it leaves by the neighbour
    float max_distance;             // boxes beyond it do not matter
};

inline BoxRay box_ray(const Ray& ray, float max_distance, float reach) {
    const glm::vec3 &o = ray.origin, &d = ray.direction;
    const float furthest = reach + max_of(std::abs(o.x), max_of(std::abs(o.y), std::abs(o.z)));
    const RayAxis x = ray_axis(o.x, d.x, furthest), y = ray_axis(o.y, d.y, furthest),
                  z = ray_axis(o.z, d.z, furthest);
    return {x, y, z, 0 + x.backwards, 2 + y.backwards, 4 + z.backwards, max_distance * kBoxTolerance};
}

template <class F>
struct Slab {
    F in, out;  // the distances between which the ray is between two planes
};
template <class F>
CREVICE_INLINE Slab<F> slab(const RayAxis& axis, std::int32_t in, const BvhNode& node, int lane) {
    return {(load<F>(node.bounds[in] + lane) - F(axis.origin_in)) * F(axis.inverse),
            (load<F>(node.bounds[in ^ 1] + lane) - F(axis.origin_out)) * F(axis.inverse)};
}

// Which children's boxes the ray enters, as bits, and at what distance.
//
// A plane that is parallel to the ray and runs through its origin is met at 0 * inf, which is not a number
// and bounds nothing: max_of and min_of keep the other operand of one in the first place.
template <class F>
CREVICE_INLINE std::uint32_t entered_children(const BoxRay& ray, const BvhNode& node, float* distance) {
    std::uint32_t entered = 0;
    for (int i = 0; i < kBvhWidth; i += kLanes<F>) {
        const Slab<F> x = slab<F>(ray.x, ray.in_x, node, i), y = slab<F>(ray.y, ray.in_y, node, i),
                      z = slab<F>(ray.z, ray.in_z, node, i);
        const F in = max_of(z.in, max_of(y.in, max_of(x.in, F(0))));
        const F out = min_of(z.out, min_of(y.out, min_of(x.out, F(ray.max_distance))));
        store(distance + i, in);
        entered |= lane_bits(in <= F(kBoxTolerance) * out) << i;
    }
    return entered;
}

// Children still to be visited, the next one on top. Of a node's children at most seven wait while the eighth
// is visited, and no path from the root has more than kBvhMaxDepth nodes, so there are never more than kMost.
struct WaitingChildren {
    static constexpr int kMost = (kBvhWidth - 1) * kBvhMaxDepth;
    std::int32_t child[kMost];
    float distance[kMost];  // at which the ray enters its box
    int count = 0;

    CREVICE_INLINE void push(std::int32_t next, float next_distance) {
        child[count] = next;
        distance[count++] = next_distance;
    }
};

// Calls visit(block) for the blocks whose boxes the ray enters, of each node the nearest child first, until one call returns
// true; whether one did. `visit` may lower ray.max_distance.
template <class F, class Visit>
CREVICE_INLINE bool traverse(const Bvh& bvh, const BoxRay& ray, const Visit& visit) {
    if (bvh.nodes.empty()) return false;
    WaitingChildren waiting;
    std::int32_t child = 0;  // the root; as in BvhNode::child
    for (;;) {
        std::uint32_t entered = 0;
        alignas(32) float distance[kBvhWidth];
        const BvhNode* node = nullptr;
        if (child >= 0) {
            node = &bvh.nodes[static_cast<std::size_t>(child)];
            entered = entered_children<F>(ray, *node, distance);
        } else if (visit(bvh.blocks[static_cast<std::size_t>(~child)])) {
            return true;
        }
        if (entered == 0) {
            do {
                if (waiting.count == 0) return false;
                --waiting.count;
            } while (waiting.distance[waiting.count] > ray.max_distance);
            child = waiting.child[waiting.count];
            continue;
        }
        int nearest = __builtin_ctz(entered);
        while ((entered &= entered - 1) != 0) {
            const int lane = __builtin_ctz(entered);
            const bool nearer = distance[lane] < distance[nearest];
            const int further = nearer ? nearest : lane;
            nearest = nearer ? lane : nearest;
            waiting.push(node->child[further], distance[further]);
        }
        child = node->child[nearest];
    }
}

// Whether one of a block's triangles is met.
template <class F>
CREVICE_INLINE bool meets_block(const Ray& ray, float max_distance, const BvhBlock& block) {
    const RayAim<float> aim = ray_aim(ray.direction, max_distance);
    std::uint32_t perhaps = 0;
    for (int i = 0; i < kBvhWidth; i += kLanes<F>) {
        const Verdict<F> found = verdict(seen_triangles<F>(ray.origin, block, i), spread<F>(aim));
        if (any(found.sure)) return true;
        perhaps |= lane_bits(found.perhaps) << i;
    }
    return meets_one_of(ray, max_distance, block, perhaps);
}

// Whether anything is met at a distance in (0, max_distance]. The ray must be usable().
template <class F>
CREVICE_INLINE bool meets_any(const Bvh& bvh, const Ray& ray, float max_distance) {
    return traverse<F>(
        bvh,
        box_ray(ray, max_distance, bvh.reach), [&](const BvhBlock& block) __attribute__((always_inline)) {
            return meets_block<F>(ray, max_distance, block);
        });
}

// The first thing met.
struct RayHit {
    float distance = std::numeric_limits<float>::infinity();  // multiples of the direction's length
    std::int32_t triangle = -1;                               // -1: nothing
    float u = 0, v = 0;  // weights of the triangle's corners 1 and 2; corner 0 has 1 - u - v
};

// For nearest_hit(): a ray goes through nothing.
struct NoHoles {
    bool operator()(std::int32_t, float, float) const { return true; }
};

// The nearest hit at a distance in (0, max_distance] of those with solid(triangle, u, v); of those equal in
// float the one with the lowest index. The ray must be usable().
template <class F, class Solid = NoHoles>
CREVICE_INLINE RayHit nearest_hit(const Bvh& bvh, const Ray& ray, float max_distance,
                                  const Solid& solid = {}) {
    RayAim<float> aim = ray_aim(ray.direction, max_distance);
    BoxRay box = box_ray(ray, max_distance, bvh.reach);
    RayHit nearest;
    traverse<F>(
        bvh, box, [&](const BvhBlock& block) __attribute__((always_inline)) {
            std::uint32_t perhaps = 0;
            for (int i = 0; i < kBvhWidth; i += kLanes<F>)
                perhaps |= lane_bits(verdict(seen_triangles<F>(ray.origin, block, i), spread<F>(aim)).perhaps)
                           << i;
            for (; perhaps != 0; perhaps &= perhaps - 1) {
                const int lane = __builtin_ctz(perhaps);
                const ExactHit hit = exact_hit(ray, max_distance, block, lane);
                if (!hit.met) continue;
                const float distance = hit.distance;
                const std::int32_t triangle = block.triangle[lane];
                if (distance > nearest.distance ||
                    (distance == nearest.distance && triangle >= nearest.triangle))
                    continue;
                if (!solid(triangle, hit.u, hit.v)) continue;
                nearest = {distance, triangle, hit.u, hit.v};
                aim.limit = distance;
                box.max_distance = distance * kBoxTolerance;
            }
            return false;
        });
    return nearest;
}

}  // namespace crevice
