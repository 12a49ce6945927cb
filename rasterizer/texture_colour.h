// What a texture says at the pixels of a fragment: colour and alpha, or the normal of a normal map.
#pragma once

#include "rasterizer/fragment.h"
#include "rasterizer/sample_texture.h"

namespace crevice {

// Where the pixels of a fragment lie in a texture, pixel by pixel: computed once for all textures of a
// material.
template <class F>
struct TextureCoordinates {
    glm::vec2 uv[kLanes<F>];
    glm::vec2 duv_dx[kLanes<F>], duv_dy[kLanes<F>];  // from the pixel to the next one in x, in y
    std::int32_t wanted[kLanes<F>];                  // 0: the pixel is not the fragment's; nothing is sampled
};

// From the mesh's texcoords, which it must have. The steps are those inside the triangle's plane, exactly
// from one pixel centre to the next. `first_vertex` is that of the instance in TransformedVertices.
template <class F>
CREVICE_INLINE TextureCoordinates<F> texture_coordinates(const Mesh& mesh, std::uint32_t first_vertex,
                                                         const ScreenTriangle& t, const Fragment<F>& f) {
    const auto uv_at = [&](const Barycentric<F>& b) __attribute__((always_inline)) {
        const glm::vec2 &uv0 = mesh.texcoords[t.vertex[0] - first_vertex],
                        &uv1 = mesh.texcoords[t.vertex[1] - first_vertex],
                        &uv2 = mesh.texcoords[t.vertex[2] - first_vertex];
        return Vec3<F>{b.interpolate(uv0.x, uv1.x, uv2.x), b.interpolate(uv0.y, uv1.y, uv2.y), F(0)};
    };
    const Vec3<F> uv = uv_at(f.here), right = uv_at(f.away(t, 1, 0)), below = uv_at(f.away(t, 0, 1));
    float u[3][kLanes<F>], v[3][kLanes<F>];
    const Vec3<F>* const at[3] = {&uv, &right, &below};
    for (int i = 0; i < 3; ++i) {
        store(u[i], at[i]->x);
        store(v[i], at[i]->y);
    }
    TextureCoordinates<F> result;
    store(result.wanted, select(f.passed, Int<F>(1), Int<F>(0)));
    for (int lane = 0; lane < kLanes<F>; ++lane) {
        const glm::vec2 here(u[0][lane], v[0][lane]);
        result.uv[lane] = here;
        result.duv_dx[lane] = glm::vec2(u[1][lane], v[1][lane]) - here;
        result.duv_dy[lane] = glm::vec2(u[2][lane], v[2][lane]) - here;
    }
    return result;
}

template <class F>
struct TextureColour {
    Vec3<F> colour;  // linear light, [0,1]
    F alpha;         // [0,1]; 1 where the texture has none
};

// Sampled pixel by pixel; 0 at pixels that are not the fragment's.
template <class F>
CREVICE_INLINE TextureColour<F> texture_colour(const Texture& texture, const Sampler& sampler,
                                               const TextureCoordinates<F>& at) {
    float rgba[4][kLanes<F>] = {};
    for (int lane = 0; lane < kLanes<F>; ++lane) {
        if (at.wanted[lane] == 0) continue;
        const glm::vec4 sampled =
            sample_texture(texture, sampler, at.uv[lane], at.duv_dx[lane], at.duv_dy[lane]);
        for (int k = 0; k < 4; ++k) rgba[k][lane] = sampled[k];
    }
    return {{load<F>(rgba[0]), load<F>(rgba[1]), load<F>(rgba[2])}, load<F>(rgba[3])};
}

template <class F>
struct MappedNormal {
    Vec3<F> n_tangent;   // unit: along the tangent, along the bitangent, along the vertex normal
    F shininess_factor;  // [0,1]; 1 where the map has no alpha
};

// From a normal map: RGB = n / 2 + 1/2 with red along +u and green along +v, which is down the picture
// (Direct3D's way); alpha multiplies the shininess (seed 002). (0, 0, 1) where the filter has averaged all
// direction away.
template <class F>
CREVICE_INLINE MappedNormal<F> mapped_normal(const Texture& map, const Sampler& sampler,
                                             const TextureCoordinates<F>& at) {
    const TextureColour<F> sampled = texture_colour<F>(map, sampler, at);
    const F one = F(1), two = F(2), zero = F(0);
    const Vec3<F> n = two * sampled.colour - Vec3<F>{one, one, one};
    return {normalize_or<F>(n, {zero, zero, one}), sampled.alpha};
}

}  // namespace crevice
