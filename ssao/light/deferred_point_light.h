// The last pass of LearnOpenGL: a picture lit from the G-buffer alone, by one point light that grows weaker with
// distance; the ambient term is multiplied by accessibility.
// Source: LearnOpenGL, chapter "SSAO", "Applying ambient occlusion" (Blinn-Phong); attenuation: its chapter "Light
//         casters"
// In:     Scene::point_light, ambient_light, sky and the diffuse colours of the materials; GBuffer with normals, and with
//         materials where the scene has more than one; an AO map of any size (empty: all open)
// Out:    RGB in linear light, >= 0; Scene::sky where nothing is seen
// Reads:  the AO map linear, clamped, at the pixel's centre
// Differs from the source: each material has its own albedo, where the text has one for all; textures and normal maps
//         are not read; no second drawing: ties in depth show what the first pass kept.
// Cost:   about 80 operations a pixel.
#pragma once

#include "rasterizer/draw/normal_depth.h"
#include "ssao/light/ambient_use.h"
#include "ssao/light/lit_explanation.h"

namespace crevice {

// Where the light and the eye are taken to be.
enum class LightSpace {
    view,  // brought to view space, where positions and normals are
    world,  // as the notes on LearnOpenGL leave them, and used with view-space positions all the same: the light
            // moves with the camera, highlights lie where nobody sees them
};

// The exponent of the highlight, the same for every surface.
inline constexpr float kPointLightShininess = 8;

// Throws UsageError for a scene without a point light.
Image3 deferred_point_light(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                            const Image<float>& ao, LightSpace space = LightSpace::view, const Run& run = {},
                            MultiBounce bounces = MultiBounce::none);
// One pixel of the same in numbers. The light has no number; what arrives of it is what its distance leaves.
LitExplanation explain_deferred_point_light(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                                            const Image<float>& ao, LightSpace space, MultiBounce bounces,
                                            int x, int y);

}  // namespace crevice
