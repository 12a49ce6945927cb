// From where a blur takes what it puts into a texel: across a step in depth, and up and down a floor.
#pragma once

#include "chapters/props/switched_ao.h"
#include "ssao/blur/bilateral_blur.h"

namespace crevice {

// One iteration of X_Jun's blur with these edges: the share of texels that it takes out of the range of the raw
// values near them in depth, within two limits, one for the horizontal and one for the vertical step.
double leaked_share(const SwitchedAo& shown, BlurEdges edges);

// Vertical taps that count.
struct KeptTaps {
    Image<float> kept;  // of each texel, 0 to 2 kBlurRadius
    int far_floor = 0,
        without = 0;  // texels of the floor from 1.1 far_z on, and those of them that keep none
    double taps = 0;  // of the far floor together
};
// The floor faces straight up in view space: the eye looks level.
KeptTaps kept_taps(const AoInputs& inputs, const BlurSettings& settings, float far_z);

}  // namespace crevice
