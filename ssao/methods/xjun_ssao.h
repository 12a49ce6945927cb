// SSAO as X_Jun computes it: chapter 32 of the DirectX 11 tutorial, which SSAO explored retells.
// In:     GBuffer, its camera
// Out:    accessibility, AO map size (half the picture unless ao_scale = 1), 1 = open; background 1; with the inputs
//         that it was computed from, for the blur
// Reads:  normals and view depth linear (the mean normal is not renormalised), border depth 100 far
// More:   luna_occlusion.h (formula, reach, differences, cost), ao_inputs.h (fetches)
#pragma once

#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// X_Jun's parameters.
inline constexpr LunaSettings kXjunSettings{};

AoFetch xjun_fetch(const LunaSettings& settings);

RawAo xjun_ssao(const GBuffer& gbuffer, const Camera& camera, const LunaSettings& settings = kXjunSettings,
                const Run& run = {});

}  // namespace crevice
