// Three components in one lane type: the vector the kernels compute with (glm::vec3 is for whole values
// outside them).
#pragma once

#include <glm/vec3.hpp>

#include "rasterizer/lanes/wide.h"

namespace crevice {

template <class F>
struct Vec3 {
    F x, y, z;

    CREVICE_INLINE friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    CREVICE_INLINE friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    CREVICE_INLINE friend Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    CREVICE_INLINE friend Vec3 operator*(F s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class F>
CREVICE_INLINE Vec3<F> spread(const glm::vec3& v) {
    return {F(v.x), F(v.y), F(v.z)};
}
template <class F>
CREVICE_INLINE F dot(Vec3<F> a, Vec3<F> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class F>
CREVICE_INLINE Vec3<F> cross(Vec3<F> a, Vec3<F> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class F>
CREVICE_INLINE Vec3<F> select(Mask<F> m, Vec3<F> a, Vec3<F> b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

// Below this squared length a vector has no direction worth keeping: normals and random vectors are unit, so
// it is absolute; vectors in scene units must be brought to order 1 before.
inline constexpr float kTinySquaredLength = 1e-12f;

// a / |a|, or `fallback` where a is (nearly) zero or not a number.
template <class F>
CREVICE_INLINE Vec3<F> normalize_or(Vec3<F> a, Vec3<F> fallback) {
    const F squared = dot(a, a);
    const auto usable = squared > F(kTinySquaredLength);
    const F inverse = F(1) / square_root(select(usable, squared, F(1)));
    return select<F>(usable, inverse * a, fallback);
}

// a / |a| for vectors of any length: the largest component is brought to 1 first, so that the squares neither
// overflow nor vanish. Zero and NaN vectors become zero.
template <class F>
CREVICE_INLINE Vec3<F> normalize_any_length(Vec3<F> a) {
    const F largest = max_of(absolute(a.x), max_of(absolute(a.y), absolute(a.z)));
    const auto usable = (largest > F(0)) & (largest < F(3.4e38f));
    const F scale = F(1) / select(usable, largest, F(1));
    const Vec3<F> zero = {F(0), F(0), F(0)};
    return normalize_or<F>(select<F>(usable, scale * a, zero), zero);
}

}  // namespace crevice
