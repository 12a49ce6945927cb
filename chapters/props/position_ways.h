// Ways to rebuild a view-space position from uv and a view depth z, right and wrong ones: for chapter 04.
#pragma once

#include "chapters/props/position_picture.h"

namespace crevice {

// The ray through (x, y) of [-1, 1]^2, y up, where it meets the plane at that view depth.
inline Vec3<float> on_plane(const ViewRays& rays, float x, float y, float plane) {
    return plane * Vec3<float>{x * rays.ray_scale.x, y * rays.ray_scale.y, 1};
}
// What a pixel gets of the corners of a quad that covers the picture.
inline Vec3<float> interpolated(const ViewRays& rays, float u, float v, float plane) {
    const Vec3<float> left = on_plane(rays, -1, 1, plane), right = on_plane(rays, 1, 1, plane),
                      below = on_plane(rays, -1, -1, plane);
    return left + u * (right - left) + v * (below - left);
}

// X_Jun: a ray to the far plane.
inline Vec3<float> by_far_plane(const ViewRays& rays, float u, float v, float z) {
    const Vec3<float> ray = interpolated(rays, u, v, 1000);
    return (z / ray.z) * ray;
}
// Luna: a ray to the near plane, where ndc depth is 0.
inline Vec3<float> by_near_plane(const ViewRays& rays, float u, float v, float z) {
    const Vec3<float> ray = interpolated(rays, u, v, 1);
    return (z / ray.z) * ray;
}
// Wrong: a unit ray, and depth taken for distance.
inline Vec3<float> by_unit_ray(const ViewRays& rays, float u, float v, float z) {
    return z * normalize_or<float>(interpolated(rays, u, v, 1), {0, 0, 1});
}
// Wrong: one triangle over the picture, whose corners are normalised before they are interpolated.
inline Vec3<float> by_unit_corners(const ViewRays& rays, float u, float v, float z) {
    const auto corner = [&](float x, float y) {
        return normalize_or<float>(on_plane(rays, x, y, 1), {0, 0, 1});
    };
    const Vec3<float> a = corner(-1, 1), b = corner(3, 1), c = corner(-1, -3);
    const Vec3<float> ray = a + (u / 2) * (b - a) + (v / 2) * (c - a);
    return (z / ray.z) * ray;
}
// Wrong, SSAO explored: the far plane's size where x and y in -1 to 1 need half of it.
inline Vec3<float> by_full_size(const ViewRays& rays, float u, float v, float z) {
    const Vec3<float> p = by_far_plane(rays, u, v, z);
    return {2 * p.x, 2 * p.y, p.z};
}
// Wrong, Luna: (p.z/v/z) v, as printed.
inline Vec3<float> as_misprinted(const ViewRays& rays, float u, float v, float z) {
    const Vec3<float> ray = interpolated(rays, u, v, 1);
    return {z / ray.x / z * ray.x, z / ray.y / z * ray.y, z / ray.z / z * ray.z};
}

// A way to a position: its name in pictures, and in words.
struct Way {
    const char* name;
    const char* words;
    Position position;
};
inline constexpr Way kWays[] = {
    {"far_plane", "a ray to the far plane, X_Jun's", by_far_plane},
    {"near_plane", "a ray to the near plane, Luna's", by_near_plane},
    {"unit_ray", "a ray of length 1, z taken for a distance", by_unit_ray},
    {"unit_corners", "corner rays normalised before they are interpolated", by_unit_corners},
    {"full_size", "the whole size of the far plane for half of it", by_full_size},
    {"misprint", "(p.z / v / z) v, as printed", as_misprinted}};

}  // namespace crevice
