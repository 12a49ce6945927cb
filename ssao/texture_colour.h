// The texture's colour at the pixels of a fragment.
#pragma once

#include "rasterizer/fragment.h"
#include "rasterizer/sample_texture.h"

namespace crevice {

// Sampled pixel by pixel, trilinear, with the level of detail from the coordinates one pixel to the right and one
// below. `first_vertex` is that of the instance in TransformedVertices.
template <class F>
CREVICE_INLINE Vec3<F> texture_colour(const Texture& texture, const Mesh& mesh, std::uint32_t first_vertex,
                                      const ScreenTriangle& t, const Fragment<F>& f) {
    const auto uv_at = [&](const Barycentric<F>& b) __attribute__((always_inline)) {
        const glm::vec2 &uv0 = mesh.texcoords[t.vertex[0] - first_vertex],
                        &uv1 = mesh.texcoords[t.vertex[1] - first_vertex],
                        &uv2 = mesh.texcoords[t.vertex[2] - first_vertex];
        return Vec3<F>{b.interpolate(uv0.x, uv1.x, uv2.x), b.interpolate(uv0.y, uv1.y, uv2.y), F(0)};
    };
    const Vec3<F> uv = uv_at(f.here), right = uv_at(f.away(t, 1, 0)), below = uv_at(f.away(t, 0, 1));
    float u[3][kLanes<F>], v[3][kLanes<F>], colour[3][kLanes<F>] = {};
    const Vec3<F>* const at[3] = {&uv, &right, &below};
    for (int i = 0; i < 3; ++i) {
        store(u[i], at[i]->x);
        store(v[i], at[i]->y);
    }
    std::int32_t wanted[kLanes<F>];
    store(wanted, select(f.passed, Int<F>(1), Int<F>(0)));
    for (int lane = 0; lane < kLanes<F>; ++lane) {
        if (wanted[lane] == 0) continue;
        const glm::vec2 here(u[0][lane], v[0][lane]);
        const glm::vec3 c = sample_trilinear(texture, here, glm::vec2(u[1][lane], v[1][lane]) - here,
                                             glm::vec2(u[2][lane], v[2][lane]) - here);
        for (int k = 0; k < 3; ++k) colour[k][lane] = c[k];
    }
    return {load<F>(colour[0]), load<F>(colour[1]), load<F>(colour[2])};
}

}  // namespace crevice
