// What a method sees that reads depths and nothing else: the pixel under each texel's centre.
// In:     GBuffer; its normals may be missing
// Out:    AoInputs without a depth map; normals (0,0,0), background view_depth +inf
#pragma once

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// The column (or row) of `pixels` that lies under the centre of a texel, of `texels`; the second of two.
inline int pixel_under_centre(int texel, int texels, int pixels) {
    return static_cast<int>((2 * std::int64_t{texel} + 1) * pixels / (2 * std::int64_t{texels}));
}

AoInputs depth_inputs(const GBuffer& gbuffer, const Camera& camera, float scale, const Run& run = {});

}  // namespace crevice
