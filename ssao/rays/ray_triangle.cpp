#include "ssao/rays/ray_triangle.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

// The axes and the shear that turn a ray into the z axis. "Depth" is the distance along the axis of the direction's
// largest component, forwards positive.
struct RaySpace {
    int x, y, z;              // axes of the world; z the dominant one
    double shear_x, shear_y;  // in [-1, 1]
    double forward;           // 1 or -1, the sign of the direction along z
};

RaySpace ray_space(const Ray& ray) {
    constexpr int kNext[] = {1, 2, 0, 1};
    const glm::vec3 size = glm::abs(ray.direction);
    const int z = size.z > max_of(size.x, size.y) ? 2 : size.y > size.x ? 1 : 0;
    const int x = kNext[z], y = kNext[z + 1];
    const double along = ray.direction[z];
    return {x, y, z, ray.direction[x] / along, ray.direction[y] / along, along < 0 ? -1.0 : 1.0};
}

// A triangle in a ray's space.
struct ShearedTriangle {
    double u, v, w;        // edge functions: twice the signed area that is opposite to corner 0, 1, 2
    double area;           // |u + v + w|
    double depth_by_area;  // of the plane where the ray meets it, times `area`
    double depth_error;    // depth_by_area is off by this at most where the ray passes through the triangle
};

Vec3<double> in_ray_space(const Ray& ray, const RaySpace& space, const BvhBlock& block, int corner,
                          int lane) {
    const auto from_origin = [&](int axis) {
        return static_cast<double>(block.corner[corner][axis][lane]) - static_cast<double>(ray.origin[axis]);
    };
    const double z = from_origin(space.z);
    return {from_origin(space.x) - space.shear_x * z, from_origin(space.y) - space.shear_y * z, z};
}

double largest(double a, double b, double c) { return max_of(std::abs(a), max_of(std::abs(b), std::abs(c))); }

// The errors, with s = the largest |x| or |y|, z the largest |z| and e = 2^-53: a difference of coordinates,
// |a - origin| <= s + z, is off by e (s + z); the product with the shear by 3 e z; their difference by e s more. So
// x and y are off by e (2 s + 4 z), a product of two of them by 2 s e (2 s + 4 z) + e s^2, and the difference of two such
// products by e s (12 s + 16 z). 20 covers the terms in e^2. Below the smallest normal number products lose digits.
ShearedTriangle sheared_triangle(const Ray& ray, const BvhBlock& block, int lane) {
    constexpr double kRoundoff = 0x1p-53, kSmallestProduct = 0x1p-1022;
    const RaySpace space = ray_space(ray);
    const Vec3<double> a = in_ray_space(ray, space, block, 0, lane),
                       b = in_ray_space(ray, space, block, 1, lane),
                       c = in_ray_space(ray, space, block, 2, lane);
    const double side = max_of(largest(a.x, b.x, c.x), largest(a.y, b.y, c.y)),
                 depth = largest(a.z, b.z, c.z);
    ShearedTriangle t;
    t.u = c.x * b.y - c.y * b.x;
    t.v = a.x * c.y - a.y * c.x;
    t.w = b.x * a.y - b.y * a.x;
    const double edge_error = 20 * kRoundoff * side * (side + depth) + kSmallestProduct;
    const double signed_area = t.u + t.v + t.w;
    t.area = std::abs(signed_area);
    const double sum = space.forward * (t.u * a.z + t.v * b.z + t.w * c.z);
    t.depth_by_area = signed_area < 0 ? -sum : sum;
    const double area_error = 4 * edge_error + 8 * kRoundoff * t.area;
    t.depth_error = depth * area_error + kSmallestProduct;
    return t;
}

}  // namespace

// As in seen_triangles(), with e = 2^-53 and edges of at most 2 m: off by 100 e (2 m)^2 m, less than 2^-44 m^3. What
// exact_hit() calls met depends on less than 2^-41 m^3 more. Rounding to float is off by less than 2^-23 of the volume.
SeenVolume volume_in_double(const glm::vec3& origin, const BvhBlock& block, int lane) {
    const auto from_origin = [&](int corner) {
        const auto& at = block.corner[corner];
        return glm::dvec3(at[0][lane], at[1][lane], at[2][lane]) - glm::dvec3(origin);
    };
    const glm::dvec3 a = from_origin(0), b = from_origin(1), c = from_origin(2);
    const auto volume = static_cast<float>(2 * glm::dot(a, glm::cross(b - a, a - c)));
    const double away =
        max_of(largest(a.x, a.y, a.z), max_of(largest(b.x, b.y, b.z), largest(c.x, c.y, c.z)));
    return {volume,
            static_cast<float>(0x1p-40 * away * away * away) + 0x1p-23f * std::abs(volume) + 0x1p-100f};
}

ExactHit exact_hit(const Ray& ray, float max_distance, const BvhBlock& block, int lane) {
    const ShearedTriangle t = sheared_triangle(ray, block, lane);
    // An edge function of 0 is inside on both sides of the edge: the ray cannot pass between them.
    const bool inside = (t.u >= 0 && t.v >= 0 && t.w >= 0) || (t.u <= 0 && t.v <= 0 && t.w <= 0);
    if (!inside || !(t.area > 0) || !(t.depth_by_area > t.depth_error)) return {};
    const glm::vec3 size = glm::abs(ray.direction);
    const auto along = static_cast<double>(max_of(size.x, max_of(size.y, size.z)));
    const auto distance = static_cast<float>((t.depth_by_area + t.depth_error) / (t.area * along));
    return {distance <= max_distance, distance, static_cast<float>(std::abs(t.v) / t.area),
            static_cast<float>(std::abs(t.w) / t.area)};
}

void require_max_distance(float max_distance) {
    if (!(max_distance > 0))
        throw UsageError("max_distance: must lie in (0, inf] (" + shortest_text(max_distance) +
                         "); choose another value");
}

}  // namespace crevice
