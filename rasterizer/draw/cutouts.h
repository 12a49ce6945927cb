// Holes in surfaces: fragments whose texture's alpha is below the material's cutoff, dropped the same way in
// every pass of a view.
// Source: X_Jun, clip(alpha - 0.1) in its normal, shadow and lit passes
#pragma once

#include "rasterizer/draw/texture_colour.h"

namespace crevice {

bool has_cutouts(const Material& material);
bool has_cutouts(const Scene& scene);

// For the `kept` of a shader; see rasterize().
struct MaterialCutouts {
    const Scene& scene;
    bool cut = true;  // false: surfaces are whole

    template <class F>
    CREVICE_INLINE Mask<F> kept(const ScreenGeometry& geometry, const ScreenTriangle& t,
                                const Fragment<F>& f) const {
        const Material& material = scene.materials[static_cast<std::size_t>(t.material)];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[t.instance].mesh)];
        if (!cut || !has_cutouts(material) || mesh.texcoords.empty()) return F(0) == F(0);
        const TextureCoordinates<F> at =
            texture_coordinates(mesh, geometry.vertices.first_vertex[t.instance], t, f);
        return texture_colour<F>(*material.texture, material.sampler, at).alpha >= F(material.alpha_cutoff);
    }
};

// A shader that draws whole surfaces, with their holes left open. It must have a member `geometry`.
template <class Whole>
struct CutShader : Whole {
    MaterialCutouts cutouts;

    template <class F>
    CREVICE_INLINE Mask<F> kept(const ScreenTriangle& t, const Fragment<F>& f) const {
        return cutouts.kept(this->geometry, t, f);
    }
};

}  // namespace crevice
