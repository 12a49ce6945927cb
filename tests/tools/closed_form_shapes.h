// Triangles of the scenes whose ambient occlusion is known. Every shape is given around a place of its own,
// kPlace, so that neither points nor planes lie at the origin of the rays, where rounding would be too kind.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/cube_sphere.h"
#include "ssao/rays/surface_points.h"
#include "tests/tools/ray_checks.h"

namespace crevice {

inline constexpr glm::dvec3 kPlace = {0.75, 0.5, -1.25};

inline glm::vec3 placed(glm::dvec3 p) { return glm::vec3(kPlace + p); }

// "Infinite" planes end this far away. What a plane at distance x then leaves open lies within x / kFar of
// the plane's own directions: 2 / pi of that share by cosine, 1 / 2 evenly spread.
inline constexpr double kFar = 65536;
// By how much that changes an answer at most, for points up to 4 from the plane.
inline constexpr double kTruncation = 4 / kFar;

// Circles are polygons of this many sides, between the circles of radius a cos(pi / kSides) and a.
inline constexpr int kSides = 512;
inline const double kInnerCircle = std::cos(kPi / kSides);

// Spheres have all corners on the sphere; kSphereSagitta is how far, in radii, its planes are inside of it at
// most. A cell has sides of pi / 2 / kSphereCells or less, so a triangle's corners lie on a circle of at most
// 1 / sqrt(2) of that.
inline constexpr int kSphereCells = 96;
inline constexpr double kSphereSagitta = kPi * kPi / 16 / kSphereCells / kSphereCells;

using Triangles = std::vector<Corners>;

// corner, corner + a, corner + a + b, corner + b
inline Triangles rectangle(glm::dvec3 corner, glm::dvec3 a, glm::dvec3 b) {
    const glm::vec3 p[] = {placed(corner), placed(corner + a), placed(corner + a + b), placed(corner + b)};
    return {{p[0], p[1], p[2]}, {p[0], p[2], p[3]}};
}

// The rectangle between two opposite corners, parallel to two axes.
inline Triangles level_rectangle(glm::dvec2 low_xz, glm::dvec2 high_xz, double y) {
    const glm::dvec2 size = high_xz - low_xz;
    return rectangle({low_xz.x, y, low_xz.y}, {size.x, 0, 0}, {0, 0, size.y});
}

// A corner of the polygon around the y axis; the middle of a side lies at +x.
inline glm::dvec3 on_circle(int corner, double radius, double y) {
    const double angle = (corner + 0.5) * 2 * kPi / kSides;
    return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

inline Triangles disc(double radius, double y) {
    Triangles triangles;
    for (int i = 0; i < kSides; ++i)
        triangles.push_back(
            {placed({0, y, 0}), placed(on_circle(i, radius, y)), placed(on_circle(i + 1, radius, y))});
    return triangles;
}

// The wall of a round pit from y = low up to 0.
inline Triangles tube(double radius, double low) {
    Triangles triangles;
    for (int i = 0; i < kSides; ++i) {
        const glm::vec3 a = placed(on_circle(i, radius, low)), b = placed(on_circle(i + 1, radius, low)),
                        c = placed(on_circle(i, radius, 0)), d = placed(on_circle(i + 1, radius, 0));
        triangles.push_back({a, b, c});
        triangles.push_back({c, b, d});
    }
    return triangles;
}

// A closed sphere of radius 1 around kPlace.
inline Triangles unit_sphere() {
    const CubeSphere sphere = cube_sphere(kSphereCells);
    Triangles triangles;
    for (const auto& t : sphere.triangles)
        triangles.push_back({placed(sphere.directions[t[0]]), placed(sphere.directions[t[1]]),
                             placed(sphere.directions[t[2]])});
    return triangles;
}

inline std::shared_ptr<const RayScene> scene_of_shapes(const std::vector<Triangles>& shapes) {
    Triangles all;
    for (const Triangles& shape : shapes) all.insert(all.end(), shape.begin(), shape.end());
    return std::make_shared<const RayScene>(scene_of_triangles(all));
}

// A point of a triangle and its unit normal, on the side that `towards` lies (relative to the triangle).
inline SurfacePoint point_of_triangle(const Corners& c, glm::dvec3 weights, glm::dvec3 towards) {
    const glm::dvec3 p =
        weights.x * glm::dvec3(c[0]) + weights.y * glm::dvec3(c[1]) + weights.z * glm::dvec3(c[2]);
    const glm::dvec3 n =
        glm::normalize(glm::cross(glm::dvec3(c[1]) - glm::dvec3(c[0]), glm::dvec3(c[2]) - glm::dvec3(c[0])));
    const glm::vec3 normal(glm::dot(n, towards) < 0 ? -n : n);
    return {glm::vec3(p), normal, normal};
}

}  // namespace crevice
