// The angle between two vectors without libm, so that it has the same bits everywhere.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/lanes/approx_math.h"

namespace crevice {

// Arc tangent of t in [0,1], absolute error below 1e-15: four halvings bring the angle below pi/64, then
// Taylor's series.
inline double arc_tangent(double t) {
    double scale = 1;
    for (int halving = 0; halving < 4; ++halving, scale *= 2) t /= 1 + std::sqrt(1 + t * t);
    const double t2 = t * t;
    double series = 0;
    for (int k = 13; k >= 1; k -= 2) series = 1.0 / k - t2 * series;
    return scale * t * series;
}

// The angle between two vectors, [0, pi], well conditioned everywhere; 0 when one of them is zero or not a
// number.
inline double angle_between(glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 normal = glm::cross(a, b);
    const double across = std::sqrt(glm::dot(normal, normal)), along = glm::dot(a, b);
    const double size = std::abs(along);
    if (!(across + size > 0)) return 0;
    const double acute = across <= size ? arc_tangent(across / size) : kPi / 2 - arc_tangent(size / across);
    return along >= 0 ? acute : kPi - acute;
}

// a / |a|; zero where a is zero or not a number.
inline glm::dvec3 unit_or_zero(glm::dvec3 a) {
    const double length = std::sqrt(glm::dot(a, a));
    return length > 0 ? a / length : glm::dvec3(0);
}

}  // namespace crevice
