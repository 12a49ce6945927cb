// The numbers of one texel of the tutorials' estimator.
#pragma once

#include "ssao/methods/explanation.h"
#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// Texel (x, y), which must lie in the map, as luna_occlusion() computes it with these settings.
Explanation explain_luna_occlusion(const AoInputs& inputs, const LunaSettings& settings, int x, int y);

}  // namespace crevice
