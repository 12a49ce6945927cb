// Where the pixels of triangles lie in their textures.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/draw/triangle_lanes.h"
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

// The coordinates of a group of pixels, and the steps from one pixel centre to the next inside the triangle's
// plane, exactly. Where a mesh has no texcoords they are 0. `wanted` is left to the caller.
template <class F, bool kAlike>
CREVICE_INLINE void find_coordinates(const TriangleLanes<F, kAlike>& triangles,
                                     const std::vector<InstanceAttributes>& attributes,
                                     SampledPixels& pixels) {
    const auto component = [&](std::size_t corner, glm::length_t i) __attribute__((always_inline)) {
        return triangles.each([&](const ScreenTriangle& t) {
            const InstanceAttributes& instance = attributes[t.instance];
            return instance.has_texcoords() ? instance.texcoord(t, corner)[i] : 0.0f;
        });
    };
    const Barycentric<F> here = triangles.here(), right = triangles.away(1, 0), below = triangles.away(0, 1);
    const auto put = [&](glm::length_t i, float* at, float* step_x, float* step_y)
        __attribute__((always_inline)) {
        const F first = component(0, i), second = component(1, i), third = component(2, i);
        const F value = here.interpolate(first, second, third);
        store(at, value);
        store(step_x, right.interpolate(first, second, third) - value);
        store(step_y, below.interpolate(first, second, third) - value);
    };
    put(0, pixels.u, pixels.du_dx, pixels.du_dy);
    put(1, pixels.v, pixels.dv_dx, pixels.dv_dy);
}

}  // namespace crevice
