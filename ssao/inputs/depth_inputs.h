// What a method sees that reads depths and nothing else: the pixel under each texel's centre.
// In:     GBuffer; its normals may be missing
// Out:    AoInputs without a depth map; normals (0,0,0), background view_depth +inf
#pragma once

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

AoInputs depth_inputs(const GBuffer& gbuffer, const Camera& camera, float scale, const Run& run = {});

}  // namespace crevice
