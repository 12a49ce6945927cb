// Does a ray meet a triangle? Watertight: no ray slips through the edge or the corner that triangles share.
// Source: Woop, Benthin & Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1): shear to the ray's
//         space, edge functions, double precision where float cannot tell.
// In:     rays and triangles relative to the same origin, scene units, |coordinates| <= kRayReach
// Out:    whether the triangle is met, from either side, at a distance in (0, max]
// Differs from the paper: float decides only what its rounding error cannot change, and double decides the
//         rest (the paper's falls back for an edge function of exactly 0). So the answer is the one double
//         gives, for the distance too. A hit whose distance double cannot tell from 0 is none: that is the
//         triangle the ray starts on. Neither is one with a triangle seen exactly edge-on.
// Cost:   about 80 operations for one triangle or eight, half of that where the ray passes by; double rarely,
//         but for triangles that are large against their distance from the origin.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/lanes/vec3.h"
#include "ssao/rays/bvh.h"

namespace crevice {

// The largest absolute coordinate of rays and triangles, 2^36 scene units. The products below stay within the
// range of a float.
inline constexpr float kRayReach = 0x1p36f;

// p = origin + t * direction. The direction need not be unit: distances are multiples of its length.
struct Ray {
    glm::vec3 origin, direction;
};

// Whether a ray can be traced: no coordinate of the origin beyond kRayReach, the largest component of the
// direction in [1 / kRayReach, kRayReach].
inline bool usable(const Ray& ray) {
    const glm::vec3 o = glm::abs(ray.origin), d = glm::abs(ray.direction);
    const bool within = o.x <= kRayReach && o.y <= kRayReach && o.z <= kRayReach;
    const bool finite = d.x <= kRayReach && d.y <= kRayReach && d.z <= kRayReach;
    return within && finite && (d.x >= 1 / kRayReach || d.y >= 1 / kRayReach || d.z >= 1 / kRayReach);
}

// The axes and the shear that turn a ray into the z axis, in float or double. "Depth" is the distance along
// the axis of the direction's largest component, forwards positive.
template <class Scalar>
struct RaySpace {
    float origin[3];
    int x, y, z;              // axes of the world; z the dominant one
    Scalar shear_x, shear_y;  // in [-1, 1]
    Scalar forward;           // 1 or -1, the sign of the direction along z
    Scalar depth_limit;       // hits beyond do not count
};

template <class Scalar>
RaySpace<Scalar> ray_space(const Ray& ray, float max_distance) {
    constexpr int kNext[] = {1, 2, 0, 1};
    // Plain arrays and no branches: which axis it is cannot be foreseen.
    const float d[] = {ray.direction.x, ray.direction.y, ray.direction.z};
    const float size_x = std::abs(d[0]), size_y = std::abs(d[1]), size_z = std::abs(d[2]);
    int z = size_y > size_x ? 1 : 0;
    z = size_z > max_of(size_x, size_y) ? 2 : z;
    const int x = kNext[z], y = kNext[z + 1];
    const Scalar along = d[z], forward = along < 0 ? Scalar(-1) : Scalar(1);
    // No hit is deeper than two reaches; finite, so that no product below is 0 * inf.
    const Scalar limit =
        std::min(static_cast<Scalar>(max_distance) * (forward * along), Scalar(4 * kRayReach));
    return {{ray.origin.x, ray.origin.y, ray.origin.z}, x, y, z, d[x] / along, d[y] / along, forward, limit};
}

// One triangle or eight as a ray sees them.
template <class F>
struct SeenTriangle {
    F u, v, w;        // edge functions: twice the signed area that is opposite to corner 0, 1, 2
    F area;           // |u + v + w|
    F depth_by_area;  // of the plane where the ray meets it, times `area`
    F edge_error;     // u, v and w are off by this at most
    F area_error;     // `area` is off by this at most, and depth_by_area ...
    F depth_error;    // ... by this, when the ray does not pass further by than edge_error
};

template <class F>
inline constexpr double kRoundoff = std::is_same_v<F, double> ? 0x1p-53 : 0x1p-24;

// Below this products lose digits, or vanish.
template <class F>
inline constexpr double kSmallestProduct = std::is_same_v<F, double> ? 0x1p-1022 : 0x1p-126;

template <class F, class Scalar>
CREVICE_INLINE Vec3<F> in_ray_space(const RaySpace<Scalar>& space, const float (&corner)[3][kBvhWidth],
                                    int lane) {
    const F z = load<F>(corner[space.z] + lane) - F(space.origin[space.z]);
    return {(load<F>(corner[space.x] + lane) - F(space.origin[space.x])) - F(space.shear_x) * z,
            (load<F>(corner[space.y] + lane) - F(space.origin[space.y])) - F(space.shear_y) * z, z};
}

template <class F>
CREVICE_INLINE F largest(Vec3<F> a, Vec3<F> b, Vec3<F> c, F Vec3<F>::*component) {
    return max_of(absolute(a.*component), max_of(absolute(b.*component), absolute(c.*component)));
}

// The errors, with s = the largest |x| or |y|, z the largest |z| and e = kRoundoff: a difference of
// coordinates, |a - origin| <= s + z, is off by e (s + z); the product with the shear by 3 e z; their
// difference by e s more. So x and y are off by e (2 s + 4 z), a product of two of them by 2 s e (2 s + 4 z)
// + e s^2, and the difference of two such products by e s (12 s + 16 z). 20 covers the terms in e^2.
template <class F, class Scalar>
CREVICE_INLINE SeenTriangle<F> seen_triangle(const RaySpace<Scalar>& space, const BvhBlock& block, int lane) {
    const Vec3<F> a = in_ray_space<F>(space, block.corner[0], lane),
                  b = in_ray_space<F>(space, block.corner[1], lane),
                  c = in_ray_space<F>(space, block.corner[2], lane);
    const F side = max_of(largest(a, b, c, &Vec3<F>::x), largest(a, b, c, &Vec3<F>::y)),
            depth = largest(a, b, c, &Vec3<F>::z);
    SeenTriangle<F> t;
    t.u = c.x * b.y - c.y * b.x;
    t.v = a.x * c.y - a.y * c.x;
    t.w = b.x * a.y - b.y * a.x;
    t.edge_error = F(static_cast<Scalar>(20 * kRoundoff<F>)) * side * (side + depth) + F(static_cast<Scalar>(kSmallestProduct<F>));
    const F signed_area = t.u + t.v + t.w;
    t.area = absolute(signed_area);
    const F sum = F(space.forward) * (t.u * a.z + t.v * b.z + t.w * c.z);
    t.depth_by_area = select(signed_area < F(0), -sum, sum);
    t.area_error = F(4) * t.edge_error + F(static_cast<Scalar>(8 * kRoundoff<F>)) * t.area;
    t.depth_error = depth * t.area_error + F(static_cast<Scalar>(kSmallestProduct<F>));
    return t;
}

// What float can say of a ray and a triangle: surely met, perhaps met, or (neither) surely not.
template <class F>
struct Verdict {
    Mask<F> sure, perhaps;
};

template <class F>
CREVICE_INLINE Verdict<F> verdict(const RaySpace<float>& space, const BvhBlock& block, int lane) {
    const SeenTriangle<F> t = seen_triangle<F>(space, block, lane);
    const F low = min_of(t.u, min_of(t.v, t.w)), high = max_of(t.u, max_of(t.v, t.w)), error = t.edge_error;
    const auto near_inside = (low >= -error) | (high <= error);
    const auto inside = (low > error) | (high < -error);
    const F limit = F(space.depth_limit), tolerance = F(1.000001f);
    const auto near_in_range =
        (t.depth_by_area >= -t.depth_error) &
        (t.depth_by_area <= tolerance * (limit * (t.area + t.area_error)) + t.depth_error);
    const auto in_range = (t.depth_by_area > t.depth_error) &
                          (tolerance * t.depth_by_area + t.depth_error < limit * (t.area - t.area_error));
    return {Mask<F>(inside & in_range), Mask<F>(near_inside & near_in_range)};
}

// Where a ray meets a triangle, found in double. The distance is the largest that double's rounding error
// allows for, which shows in float only for triangles seen nearly edge-on: so no box around the triangle is
// further.
struct ExactHit {
    bool met = false;
    float distance = 0;  // multiples of the direction's length
    float u = 0, v = 0;  // weights of the corners 1 and 2; corner 0 has 1 - u - v
};

ExactHit exact_hit(const Ray& ray, float max_distance, const BvhBlock& block, int lane);

}  // namespace crevice
