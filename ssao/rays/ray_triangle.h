// Does a ray meet a triangle? Watertight: no ray slips through the edge or the corner that triangles share.
// Source: Woop, Benthin & Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1): shear to the ray's
//         space, edge functions, double precision where float cannot tell. In float the edge functions are
//         Plücker's (Shevtsov, Soupikov & Kapustin 2007), of which most depends on the ray's origin alone.
// In:     rays and triangles relative to the same origin, scene units, |coordinates| <= kRayReach
// Out:    whether the triangle is met, from either side, at a distance in (0, max]
// Differs from the paper: float decides only what its rounding error cannot change, and double decides the
//         rest (the paper's falls back for an edge function of exactly 0). So the answer is the one double
//         gives, for the distance too. A hit whose distance double cannot tell from 0 is none: that is the
//         triangle the ray starts on. Neither is one with a triangle seen exactly edge-on.
// Cost:   about 100 operations for one triangle or eight and all rays from one point, 25 more for each ray, twice
//         that where it does not pass by; double rarely, but for triangles that are large against their distance
//         from the origin.
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

// How far rays look for triangles. Throws UsageError unless it is above 0; infinity is.
void require_max_distance(float max_distance);

// Whether a ray can be traced: no coordinate of the origin beyond kRayReach, the largest component of the
// direction in [1 / kRayReach, kRayReach].
inline bool usable(const Ray& ray) {
    const glm::vec3 o = glm::abs(ray.origin), d = glm::abs(ray.direction);
    const bool within = o.x <= kRayReach && o.y <= kRayReach && o.z <= kRayReach;
    const bool finite = d.x <= kRayReach && d.y <= kRayReach && d.z <= kRayReach;
    return within && finite && (d.x >= 1 / kRayReach || d.y >= 1 / kRayReach || d.z >= 1 / kRayReach);
}

// The direction of a ray in lanes, and how far along it hits count.
template <class F>
struct RayAim {
    Vec3<F> direction;
    F size;   // the largest |component|
    F limit;  // multiples of the direction's length
};

// No hit is further than this: two reaches, in multiples of the shortest direction. Finite, so that no product below
// is 0 * inf.
inline constexpr float kLongestRay = 0x1p100f;

inline RayAim<float> ray_aim(const glm::vec3& d, float max_distance) {
    const float size = max_of(std::abs(d.x), max_of(std::abs(d.y), std::abs(d.z)));
    return {{d.x, d.y, d.z}, size, min_of(max_distance, kLongestRay)};
}

template <class F>
CREVICE_INLINE RayAim<F> spread(const RayAim<float>& aim) {
    return {{F(aim.direction.x), F(aim.direction.y), F(aim.direction.z)}, F(aim.size), F(aim.limit)};
}

// One triangle or eight as all rays from one point see them. The lines of rays with the direction d pass by the edges
// at d.u, d.v and d.w: twice the edge functions, which are opposite to corner 0, 1 and 2. Inside all three have the same
// sign, and the plane is met at volume / (d.u + d.v + d.w).
template <class F>
struct SeenTriangles {
    Vec3<F> u, v, w;
    F volume;
    F edge_error;    // each edge function is off by this at most, times the largest |component| of d
    F volume_error;  // `volume` is off by this at most
};

template <class F>
CREVICE_INLINE Vec3<F> lowest(Vec3<F> a, Vec3<F> b) {
    return {min_of(a.x, b.x), min_of(a.y, b.y), min_of(a.z, b.z)};
}
template <class F>
CREVICE_INLINE Vec3<F> highest(Vec3<F> a, Vec3<F> b) {
    return {max_of(a.x, b.x), max_of(a.y, b.y), max_of(a.z, b.z)};
}
template <class F>
CREVICE_INLINE F highest(Vec3<F> a) {
    return max_of(a.x, max_of(a.y, a.z));
}

// In float. The errors, with m = the largest |coordinate| from the origin, s = that of an edge and e = 2^-24. A corner
// from the origin is off by e m, a sum of two by 4 e m, an edge by e s: so a component of u, a difference of two products of
// an edge and a sum, by 20 e s m, and the sum of three such products with d by 92 e s m. A component of the normal, of two
// edges, is off by 8 e s^2, and its product with a corner by 92 e s^2 m as well. What exact_hit() calls met depends on
// double's error too, in which the edges' lengths do not show: less than 2^-45 m^2 and 2^-41 m^3. The smallest terms
// are more than what is lost where products vanish.
template <class F>
CREVICE_INLINE SeenTriangles<F> seen_triangles(const glm::vec3& origin, const BvhBlock& block, int lane) {
    constexpr float kError = 100 * 0x1p-24f;
    const auto corner = [&](int i) __attribute__((always_inline)) {
        const auto& c = block.corner[i];
        return Vec3<F>{load<F>(c[0] + lane), load<F>(c[1] + lane), load<F>(c[2] + lane)};
    };
    const Vec3<F> from = spread<F>(origin), corner_a = corner(0), corner_b = corner(1), corner_c = corner(2);
    const Vec3<F> a = corner_a - from, b = corner_b - from, c = corner_c - from;
    const Vec3<F> bc = corner_c - corner_b, ca = corner_a - corner_c, ab = corner_b - corner_a;
    const Vec3<F> low = lowest(a, lowest(b, c)), high = highest(a, highest(b, c));
    const F away = max_of(highest(high), -min_of(low.x, min_of(low.y, low.z)));
    const F size = highest(high - low) + F(4 * 0x1p-24f) * away;
    const F error = F(kError) * size * away, square = away * away;
    const F volume = F(2) * dot(a, cross(ab, ca));
    return {cross(bc, b + c),
            cross(ca, c + a),
            cross(ab, a + b),
            volume,
            error + F(0x1p-45f) * square + F(0x1p-89f),
            size * error + F(0x1p-41f) * square * away + F(0x1p-100f)};
}

// A volume as in SeenTriangles and its error, found in double.
struct SeenVolume {
    float volume, error;
};
SeenVolume volume_in_double(const glm::vec3& origin, const BvhBlock& block, int lane);

// `seen`, which begins with `first` of the block's lanes, with double's volumes in those of its lanes whose bits are set.
template <class F>
CREVICE_INLINE SeenTriangles<F> with_volumes_in_double(SeenTriangles<F> seen, const glm::vec3& origin,
                                                       const BvhBlock& block, int first,
                                                       std::uint32_t lanes) {
    float volume[kLanes<F>], error[kLanes<F>];
    store(volume, seen.volume);
    store(error, seen.volume_error);
    for (; lanes != 0; lanes &= lanes - 1) {
        const int lane = __builtin_ctz(lanes);
        const SeenVolume found = volume_in_double(origin, block, first + lane);
        volume[lane] = found.volume;
        error[lane] = found.error;
    }
    seen.volume = load<F>(volume);
    seen.volume_error = load<F>(error);
    return seen;
}

// What float can say of rays and triangles: surely met, perhaps met, or (neither) surely not.
template <class F>
struct Verdict {
    Mask<F> sure, perhaps;
};

template <class F>
CREVICE_INLINE Verdict<F> verdict(const SeenTriangles<F>& seen, const RayAim<F>& ray) {
    const F u = dot(ray.direction, seen.u), v = dot(ray.direction, seen.v), w = dot(ray.direction, seen.w);
    const F error = ray.size * seen.edge_error;
    const F low = min_of(u, min_of(v, w)), high = max_of(u, max_of(v, w));
    const auto near_inside = Mask<F>((low >= -error) | (high <= error));
    if (!any(near_inside)) return {near_inside, near_inside};
    const auto inside = Mask<F>((low > error) | (high < -error));
    const F signed_area = u + v + w;
    const F area = absolute(signed_area), volume = select(signed_area < F(0), -seen.volume, seen.volume);
    const F area_error = F(4) * error + F(8 * 0x1p-24f) * area, volume_error = seen.volume_error;
    const F tolerance = F(1.000001f);
    const auto near_in_range =
        (volume >= -volume_error) & (volume <= tolerance * (ray.limit * (area + area_error)) + volume_error);
    const auto in_range =
        (volume > volume_error) & (tolerance * volume + volume_error < ray.limit * (area - area_error));
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

// Whether exact_hit() meets one of the lanes whose bits are set.
inline bool meets_one_of(const Ray& ray, float max_distance, const BvhBlock& block, std::uint32_t lanes) {
    for (; lanes != 0; lanes &= lanes - 1) {
        if (exact_hit(ray, max_distance, block, __builtin_ctz(lanes)).met) return true;
    }
    return false;
}

}  // namespace crevice
