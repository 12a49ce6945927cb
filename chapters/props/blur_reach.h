// From where a blur takes what it puts into a texel: across a step in depth, and up and down a floor.
#pragma once

#include "ssao/blur/bilateral_blur.h"

namespace crevice {

// The share of texels that one iteration took out of the range of the raw values near them in depth: within two limits
// of xjun's, one for the horizontal and one for the vertical step. Maps of one size.
double leaked_share(const Image<float>& blurred, const Image<float>& raw, const Image<float>& view_depth);

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
