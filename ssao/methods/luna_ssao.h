// SSAO as Luna computes it: Introduction to 3D Game Programming with DirectX 12, chapter 21.
// In:     GBuffer, its camera
// Out:    accessibility, AO map size (half the picture unless ao_scale = 1), 1 = open; background 1; with the inputs
//         that it was computed from, for the blur
// Reads:  the nearest pixel's normal, renormalised; ndc depth linear, turned into view depth; border on the
//         far plane
// More:   luna_occlusion.h (formula, reach, differences, cost), ao_inputs.h (fetches)
#pragma once

#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// Luna's parameters: the listing's exponent 6 (its prose says 4).
inline constexpr LunaSettings kLunaSettings{
    .fade_end = 1.0f, .exponent = 6, .depth_source = DepthSource::ndc_depth};

AoFetch luna_fetch(const LunaSettings& settings);

RawAo luna_ssao(const GBuffer& gbuffer, const Camera& camera, const LunaSettings& settings = kLunaSettings,
                const Run& run = {});

}  // namespace crevice
