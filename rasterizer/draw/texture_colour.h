// What a material's textures say at the pixels of a fragment: colour and alpha, and the normal of a normal
// map.
#pragma once

#include "rasterizer/draw/fragment.h"
#include "rasterizer/textures/sample_texture.h"

namespace crevice {

// From the mesh's texcoords, which it must have. The steps are those inside the triangle's plane, exactly
// from one pixel centre to the next. `first_vertex` is that of the instance in TransformedVertices.
template <class F>
CREVICE_INLINE TextureCoordinates<F> texture_coordinates(const Mesh& mesh, std::uint32_t first_vertex,
                                                         const ScreenTriangle& t, const Fragment<F>& f) {
    const glm::vec2 &uv0 = mesh.texcoords[t.vertex[0] - first_vertex],
                    &uv1 = mesh.texcoords[t.vertex[1] - first_vertex],
                    &uv2 = mesh.texcoords[t.vertex[2] - first_vertex];
    const auto uv_at = [&](const Barycentric<F>& b) __attribute__((always_inline)) {
        return Vec2<F>{b.interpolate(uv0.x, uv1.x, uv2.x), b.interpolate(uv0.y, uv1.y, uv2.y)};
    };
    const Vec2<F> uv = uv_at(f.here), right = uv_at(f.away(t, 1, 0)), below = uv_at(f.away(t, 0, 1));
    return {uv, {right.x - uv.x, right.y - uv.y}, {below.x - uv.x, below.y - uv.y}, f.passed};
}

// RGB and alpha; 0 at pixels that are not the fragment's.
template <class F>
CREVICE_INLINE TextureColour<F> texture_colour(const Texture& texture, const Sampler& sampler,
                                               const TextureCoordinates<F>& at) {
    return sample_texture<F>(texture, sampler, at);
}

template <class F>
struct MappedNormal {
    Vec3<F> n_tangent;   // unit: along the tangent, along the bitangent, along the vertex normal
    F shininess_factor;  // [0,1]; 1 where the map has no alpha
};

// What the colour of a normal map means: RGB = n / 2 + 1/2 with red along +u and green along +v, which is
// down the picture (Direct3D's way); alpha multiplies the shininess (Luna). (0, 0, 1) where the filter
// has averaged all direction away.
template <class F>
CREVICE_INLINE MappedNormal<F> mapped_normal(const TextureColour<F>& sampled) {
    const F one = F(1), two = F(2), zero = F(0);
    const Vec3<F> n = two * sampled.colour - Vec3<F>{one, one, one};
    return {normalize_or<F>(n, {zero, zero, one}), sampled.alpha};
}
template <class F>
CREVICE_INLINE MappedNormal<F> mapped_normal(const Texture& map, const Sampler& sampler,
                                             const TextureCoordinates<F>& at) {
    return mapped_normal<F>(sample_texture<F>(map, sampler, at));
}

// A surface's texture and normal map in one go: faster than one after the other where they are of one size.
template <class F>
struct ColourAndNormal {
    TextureColour<F> colour;
    MappedNormal<F> normal;
};
template <class F>
CREVICE_INLINE ColourAndNormal<F> colour_and_normal(const Texture& texture, const Texture& map,
                                                    const Sampler& sampler, const TextureCoordinates<F>& at) {
    const TextureColours<F> sampled = sample_textures<F>(texture, map, sampler, at);
    return {sampled.first, mapped_normal<F>(sampled.second)};
}

}  // namespace crevice
