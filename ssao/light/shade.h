// The last pass of both tutorials: the scene drawn again with its lights, depth test EQUAL and no depth
// write, the ambient terms multiplied by accessibility, and the sky behind.
// Source: X_Jun (Phong, Lighting.hlsl of its series), Luna (Default.hlsl: Blinn-Phong with the Schlick
//         approximation)
// In:     a scene, its camera; the depth buffer of the first pass; an AO map of any size (empty: all open);
//         the shadow map of the scene's first light (null: all of it arrives)
// Out:    RGB in linear light, >= 0, may exceed 1; sky colour where no fragment passed
// Reads:  the AO map (and bent normals) linear, clamped, at the pixel's centre
// Differs from the tutorials: accessibility multiplies every ambient term (in X_Jun's text only those of
//         directional lights); given the G-buffer, tiles where no depths tie are not drawn again but lit from the
//         first pass's triangles, with the same bits.
#pragma once

#include "rasterizer/base/tile_map.h"
#include "rasterizer/draw/depth_buffer.h"
#include "rasterizer/draw/normal_depth.h"
#include "ssao/light/ambient_use.h"
#include "ssao/light/lit_explanation.h"
#include "ssao/light/shadow_map.h"

namespace crevice {

struct ShadeSettings {
    DepthFunction depth_function = DepthFunction::equal;
    PositionOrder position_order = PositionOrder::relative;
    DepthBias depth_bias;
    bool cutouts = true;  // false: what the first pass cut out is drawn whole here
    NormalMatrix normal_matrix = NormalMatrix::inverse_transpose;
    bool operator==(const ShadeSettings&) const = default;
};

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const Run& run = {});
Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const ShadeSettings& settings, const Run& run = {}, const ShadowMap* shadow = nullptr,
             const AmbientUse& ambient = {});

// The same from geometry that another pass of this view shares.
Image3 shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
             const DepthBuffer& depth, const Image<float>& ao, const ShadeSettings& settings = {},
             const Run& run = {}, const ShadowMap* shadow = nullptr, const AmbientUse& ambient = {});

struct LitImage {
    Image3 image;
    // What was done with the geometry's tiles: drawn again, in part or as a whole (done), lit from the first
    // pass's triangles (lit_once), or left to the sky (background).
    TileMap tiles;
};

// The same with EQUAL, from the geometry and what the first pass, cut-outs open, made of it; see second_drawing.h.
LitImage shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
               const GBuffer& gbuffer, const Image<float>& ao, const Run& run = {},
               const ShadowMap* shadow = nullptr, const AmbientUse& ambient = {});

// One pixel of the same in numbers. (x, y) lies in the picture.
LitExplanation explain_shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
                             const GBuffer& gbuffer, const Image<float>& ao, int x, int y,
                             const Run& run = {}, const ShadowMap* shadow = nullptr,
                             const AmbientUse& ambient = {});
LitExplanation explain_shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth,
                             const Image<float>& ao, const ShadeSettings& settings, int x, int y,
                             const Run& run = {}, const ShadowMap* shadow = nullptr,
                             const AmbientUse& ambient = {});

// What a drawing of its own is made from, to compare with these depths.
GeometrySettings geometry_settings(const ShadeSettings& settings, const DepthBuffer& depth);

}  // namespace crevice
