// Tangents: the direction in which a texture's u grows along a surface, and what a normal map needs of it.
//
// The frame of a vertex is (tangent, bitangent, normal) with bitangent = w * cross(normal, tangent) along
// which v grows, down the picture. w is +1 where the texture is seen as it is painted, -1 where it is
// mirrored.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/lanes/vec3.h"

namespace crevice {

// One a vertex: unit tangent in object space, at right angles to the vertex normal, and w.
//
// A tangent is the sum of the unit directions of u in the triangles at the vertex (Lengyel 2001), each
// weighted by its angle there, less its part along the normal. Triangles without area in space or in the
// texture have no say. No vertex is split: where mirrored and plain triangles share one, those with the
// larger sum of angles (the plain ones if equal) give both tangent and w, and the frame turns over across the
// others. A model that must be exact there has two vertices along its mirror line. A vertex that nothing
// gives a direction (no texture area, u along the normal, directions that cancel) has any tangent at right
// angles to its normal, and w = 1; so has one whose normal is zero or not a number.
//
// Positions, normals (unit) and texcoords come one a vertex, or UsageError is thrown; triangles index them.
// An affine map takes tangents like positions, and where its determinant is negative it changes the sign of
// w.
std::vector<glm::vec4> vertex_tangents(std::span<const glm::vec3> positions,
                                       std::span<const glm::vec3> normals,
                                       std::span<const glm::vec2> texcoords,
                                       std::span<const std::array<std::uint32_t, 3>> triangles);

// What the colour of a normal map means: RGB = n / 2 + 1/2 with red along +u and green along +v, which is
// down the picture (Direct3D's way). Unit: along the tangent, along the bitangent, along the vertex normal;
// (0, 0, 1) where the filter has averaged all direction away.
template <class F>
CREVICE_INLINE Vec3<F> mapped_normal(Vec3<F> colour) {
    const Vec3<F> one{F(1), F(1), F(1)};
    return normalize_or<F>(F(2) * colour - one, {F(0), F(0), F(1)});
}

// The normal that a map's `n_tangent` stands for: unit, in the space of `n` and `tangent`. `n` is unit;
// `tangent` is interpolated, of any length and not quite at right angles; of `handedness` only the sign
// counts. `n` itself where the tangent vanishes.
template <class F>
CREVICE_INLINE Vec3<F> bumped_normal(Vec3<F> n, Vec3<F> tangent, F handedness, Vec3<F> n_tangent) {
    const F zero = F(0);
    const Vec3<F> t = normalize_or<F>(tangent - dot(tangent, n) * n, {zero, zero, zero});
    const Vec3<F> across{n.y * t.z - n.z * t.y, n.z * t.x - n.x * t.z, n.x * t.y - n.y * t.x};
    const F along_bitangent = select(handedness < zero, zero - n_tangent.y, n_tangent.y);
    return normalize_or<F>(n_tangent.x * t + along_bitangent * across + n_tangent.z * n, n);
}

}  // namespace crevice
