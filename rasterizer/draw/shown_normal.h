// The normal that a fragment shows: interpolated from the vertices, bent by the material's normal map where
// there is one.
#pragma once

#include "rasterizer/draw/texture_colour.h"
#include "rasterizer/scene/tangents.h"

namespace crevice {

// View space, unit; `n_tangent` is what the normal map says there. On a back face whose normal was turned to
// the eye the bitangent stays where it was: the picture painted on a surface does not turn with its normal.
template <class F>
CREVICE_INLINE Vec3<F> bent_normal(const ScreenGeometry& geometry, const Mesh& mesh, const ScreenTriangle& t,
                                   const Fragment<F>& f, const Vec3<F>& n_tangent) {
    const TangentTurn& turn = geometry.tangent_turns[t.instance];
    const std::uint32_t first = geometry.vertices.first_vertex[t.instance];
    const glm::vec4 &t0 = mesh.tangents[t.vertex[0] - first], &t1 = mesh.tangents[t.vertex[1] - first],
                    &t2 = mesh.tangents[t.vertex[2] - first];
    const glm::mat3& m = turn.view_from_object;
    const Vec3<F> tangent = f.here.interpolate(m * glm::vec3(t0), m * glm::vec3(t1), m * glm::vec3(t2));
    F handedness = F(turn.handedness) * f.here.interpolate(t0.w, t1.w, t2.w);
    const Vec3<F> n = interpolated_normal(geometry, t, f);
    if (t.back_facing) {
        const std::vector<glm::vec3>& n_view = geometry.vertices.n_view;
        const Vec3<F> front =
            f.here.interpolate(n_view[t.vertex[0]], n_view[t.vertex[1]], n_view[t.vertex[2]]);
        handedness = select(dot(n, front) < F(0), F(0) - handedness, handedness);
    }
    return bumped_normal(unit_normal(n), tangent, handedness, n_tangent);
}

// Of a pass that reads no texture but the normal map. Not normalised where there is no map.
template <class F>
CREVICE_INLINE Vec3<F> shown_normal(const Scene& scene, const ScreenGeometry& geometry,
                                    const ScreenTriangle& t, const Fragment<F>& f) {
    const Material& material = scene.materials[static_cast<std::size_t>(t.material)];
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[t.instance].mesh)];
    if (!is_normal_mapped(material, mesh)) return interpolated_normal(geometry, t, f);
    const TextureCoordinates<F> at =
        texture_coordinates(mesh, geometry.vertices.first_vertex[t.instance], t, f);
    return bent_normal(geometry, mesh, t, f,
                       mapped_normal<F>(*material.normal_map, material.sampler, at).n_tangent);
}

}  // namespace crevice
