// Where the pixels of triangles lie in their textures.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/draw/triangle_pixels.h"
#include "rasterizer/textures/sample_texture.h"

namespace crevice {

// What the vertices of an instance have beside position and normal.
struct InstanceAttributes {
    const Mesh* mesh;
    std::uint32_t first_vertex;  // of the instance in TransformedVertices

    bool has_texcoords() const { return !mesh->texcoords.empty(); }
    bool has_tangents() const { return has_texcoords() && !mesh->tangents.empty(); }
    const glm::vec2& texcoord(const ScreenTriangle& t, std::size_t corner) const {
        return mesh->texcoords[t.vertex[corner] - first_vertex];
    }
    const glm::vec4& tangent(const ScreenTriangle& t, std::size_t corner) const {
        return mesh->tangents[t.vertex[corner] - first_vertex];
    }
};

// One an instance of the scene, which must outlive them.
std::vector<InstanceAttributes> instance_attributes(const Scene& scene, const ScreenGeometry& geometry);

// Texture coordinates of a group of pixels, and the steps from one pixel centre to the next inside the triangle's
// plane, exactly.
template <class F>
struct TexturePixels {
    F u, v, du_dx, dv_dx, du_dy, dv_dy;
};
// The instance must have texcoords.
template <class F>
CREVICE_INLINE TexturePixels<F> texture_pixels(const TrianglePixels<F>& pixels,
                                               const InstanceAttributes& instance) {
    const glm::vec2 &uv0 = instance.texcoord(pixels.triangle, 0),
                    &uv1 = instance.texcoord(pixels.triangle, 1),
                    &uv2 = instance.texcoord(pixels.triangle, 2);
    const Barycentric<F> right = pixels.away(1, 0), below = pixels.away(0, 1);
    const F u = pixels.here.interpolate(uv0.x, uv1.x, uv2.x),
            v = pixels.here.interpolate(uv0.y, uv1.y, uv2.y);
    return {u,
            v,
            right.interpolate(uv0.x, uv1.x, uv2.x) - u,
            right.interpolate(uv0.y, uv1.y, uv2.y) - v,
            below.interpolate(uv0.x, uv1.x, uv2.x) - u,
            below.interpolate(uv0.y, uv1.y, uv2.y) - v};
}
// Into memory, to be sampled, at the pixels that show this triangle.
template <class F>
CREVICE_INLINE void put_where(Mask<F> shown, const TexturePixels<F>& at, SampledPixels& pixels) {
    const auto put = [&](float* to, F value) __attribute__((always_inline)) {
        store(to, select(shown, value, load<F>(to)));
    };
    put(pixels.u, at.u);
    put(pixels.v, at.v);
    put(pixels.du_dx, at.du_dx);
    put(pixels.dv_dx, at.dv_dx);
    put(pixels.du_dy, at.du_dy);
    put(pixels.dv_dy, at.dv_dy);
}

}  // namespace crevice
