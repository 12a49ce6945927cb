// What a smooth surface mirrors of its surroundings.
// Source: Luna (Default.hlsl): the cube map in the mirrored direction, times Schlick's Fresnel term and
//         the material's smoothness, added to the lit colour.
#pragma once

#include <glm/mat3x3.hpp>

#include "rasterizer/textures/cube_map.h"
#include "ssao/light/fresnel.h"

namespace crevice {

// v in another orthonormal frame; the matrix is the same for all lanes.
template <class F>
CREVICE_INLINE Vec3<F> turned(const glm::mat3& m, Vec3<F> v) {
    return {F(m[0].x) * v.x + F(m[1].x) * v.y + F(m[2].x) * v.z,
            F(m[0].y) * v.x + F(m[1].y) * v.y + F(m[2].y) * v.z,
            F(m[0].z) * v.x + F(m[1].z) * v.y + F(m[2].z) * v.z};
}

// A mirror's surroundings, and how the view's axes lie in them (the cube map is in world space).
struct Surroundings {
    const CubeMap& cube;
    glm::mat3 world_from_view;  // CameraMatrices::relative_from_view
};

// The direction in which v, which points away from the surface, leaves it mirrored; both unit, n the normal.
template <class F>
CREVICE_INLINE Vec3<F> mirrored(Vec3<F> n, Vec3<F> v) {
    return F(2) * dot(n, v) * n - v;
}

// To be added to the lit colour, linear light. n and to_eye unit, view space; `r0` the reflectance straight
// on; `smoothness` 1 - roughness, in [0,1] (Material::shininess / 256), times the normal map's alpha where
// there is one. Of the cube map's sharpest level; not multiplied by accessibility, as in the book.
template <class F>
CREVICE_INLINE Vec3<F> reflected_colour(const Surroundings& around, Vec3<F> n, Vec3<F> to_eye, Vec3<F> r0,
                                        F smoothness) {
    const Vec3<F> seen = sample_cube(around.cube, turned(around.world_from_view, mirrored(n, to_eye)));
    return smoothness * (schlick_fresnel(r0, dot(n, to_eye)) * seen);
}

}  // namespace crevice
