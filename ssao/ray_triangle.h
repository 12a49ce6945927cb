// Does a ray meet a triangle? Watertight: no ray slips through the edge or the corner that triangles share.
// Source: Woop, Benthin & Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1): shear to the ray's
//         space, edge functions, double precision where float cannot tell.
// In:     rays and triangles relative to the same origin, scene units, |coordinates| <= kRayReach
// Out:    whether the triangle is met, from either side, at a distance in (0, max]
// Differs from the paper: float decides only what its rounding error cannot change, and double decides the
//         rest (the paper's falls back for an edge function of exactly 0). So the answer is the one that double
//         gives, for the distance too: a hit whose distance double cannot tell from 0 is none, and neither is
//         one with a triangle seen exactly edge-on.
// Cost:   about 80 operations for one triangle or eight; double for one ray in some hundreds, more often for
//         triangles larger than their distance from the origin.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/vec3.hpp>

#include "rasterizer/vec3.h"
#include "ssao/bvh.h"

namespace crevice {

// The largest absolute coordinate of rays and triangles: beyond it the products of edge functions and distances
// could leave the range of a float.
inline constexpr float kRayReach = 1099511627776.0f;  // 2^40

// p = origin + t * direction. The direction need not be unit; distances are multiples of its length.
struct Ray {
    glm::vec3 origin, direction;
};

// Whether a ray can be traced: origin within kRayReach, direction finite and not 0.
inline bool usable(const Ray& ray) {
    bool finite = true, moves = false;
    for (int axis = 0; axis < 3; ++axis) {
        finite = finite && std::abs(ray.origin[axis]) <= kRayReach && std::isfinite(ray.direction[axis]);
        moves = moves || ray.direction[axis] != 0;
    }
    return finite && moves;
}

// Ray space: z along the axis of the direction's largest component, x and y sheared so that the ray runs along
// z. "Depth" is the distance along that axis.
template <class F>
struct RaySpace {
    int x, y, z;         // axes
    F shear_x, shear_y;  // in [-1, 1]
    F forward;           // 1 or -1, the direction's sign
    F depth_limit;       // up to which hits count
};

inline int dominant_axis(const glm::vec3& v) {
    const float x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
    return x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
}

template <class F>
CREVICE_INLINE RaySpace<F> ray_space(const Ray& ray, float max_distance) {
    constexpr int kNext[] = {1, 2, 0, 1};
    const int z = dominant_axis(ray.direction), x = kNext[z], y = kNext[z + 1];
    const F along = F(ray.direction[z]);
    const F forward = along < F(0) ? F(-1) : F(1);
    return {x, y, z, F(ray.direction[x]) / along, F(ray.direction[y]) / along, forward,
            F(max_distance) * (forward * along)};
}

// One triangle or eight in ray space: edge functions, and what is certain about them.
template <class F>
struct TriangleInRaySpace {
    F u, v, w;     // twice the signed area opposite corner 0, 1, 2
    F edge_error;  // of each of them, at most
    F area;        // |u + v + w|
    F depth;       // of the ray's hit with the plane, times `area`
    F reach;       // the largest |z| of a corner

    // The largest error of `area`, and of `depth` where the ray passes the triangle, as a share of `reach`.
    CREVICE_INLINE F area_error(F roundoff) const { return F(4) * edge_error + F(8) * roundoff * area; }
};

template <class F>
inline constexpr double kRoundoff = 0x1p-24;
template <>
inline constexpr double kRoundoff<double> = 0x1p-53;

template <class F>
CREVICE_INLINE Vec3<F> corner_in_ray_space(const RaySpace<F>& space, const glm::vec3& origin,
                                           const float (&corner)[3][kBvhWidth], int lane) {
    const F x = F(load<F>(corner[space.x] + lane)) - F(origin[space.x]);
    const F y = F(load<F>(corner[space.y] + lane)) - F(origin[space.y]);
    const F z = F(load<F>(corner[space.z] + lane)) - F(origin[space.z]);
    return {x - space.shear_x * z, y - space.shear_y * z, z};
}
