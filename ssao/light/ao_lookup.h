// The AO map as a pixel shader reads it: through a sampler, right, or with the slip of X_Jun's vertex shader.
//
// That shader adds (w, w) to clip x and y before scaling by (1/2, -1/2), where (w, -w) is right: v comes out
// too small by exactly 1. A sampler that wraps finds the right row all the same, so nobody noticed (the
// repository was mended in 2022); one that clamps reads the top row everywhere.
#pragma once

#include "rasterizer/base/image.h"
#include "rasterizer/textures/sampler.h"
#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// The map at the centres of a picture's pixels, filtered linearly, at v + `shift`; `mode` says what lies
// outside [0,1]. 1 everywhere when the map is empty.
Image<float> map_at_pixels(const Image<float>& ao, Size picture, AddressMode mode, float shift);

enum class AoLookup {
    exact,       // as shade() reads it, clamped
    slip_wrap,   // v - 1, WRAP
    slip_clamp,  // v - 1, CLAMP
    joint,       // brought to the picture's size first (joint_upsampling.h)
};

// The map that shade() must be given so that it shows the picture of `gbuffer` what such a lookup would; the map itself
// when exact. `inputs` are those that the map was made of.
Image<float> looked_up(const Image<float>& ao, const AoInputs& inputs, const GBuffer& gbuffer,
                       AoLookup lookup, const Run& run = {});

}  // namespace crevice
