// A half-size AO map brought to the size of the picture, where linear filtering would mix what lies on both sides of an
// edge: each of the four texels around a pixel counts less the further its surface lies off the pixel's plane.
// Source: Kopf et al. 2007, "Joint bilateral upsampling", equation 4, with a reciprocal of the distance from the plane for
//         the range kernel
// In:     an AO map, the AoInputs it was made of, the GBuffer that those were made of, with normals
// Out:    accessibility in [0,1] a pixel of the picture, within the range of the texels it is made of; background 1
// Reach:  1 texel
// Differs from the source: a Gaussian of the range vanishes where no texel is like the pixel, which leaves 0 / 0; the
//         reciprocal leaves the likest.
// Cost:   about 60 operations and eight reads a pixel; a map of the picture's own size is handed through.
#pragma once

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

Image<float> joint_upsampling(const Image<float>& ao, const AoInputs& inputs, const GBuffer& gbuffer,
                              const Run& run = {});

}  // namespace crevice
