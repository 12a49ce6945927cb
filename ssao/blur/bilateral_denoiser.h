// The tutorials' blur as the denoiser of a method.
#pragma once

#include "ssao/blur/bilateral_blur.h"
#include "ssao/methods/method.h"

namespace crevice {

// Its settings are BlurSettings, but that it stores its maps as the raw map is stored.
// For maps whose noise is the same every eight texels: a box of eight, widened by one of four, so that on one surface each
// texel of such a square has exactly the same share of the sum, and nothing of the pattern is left.
inline constexpr BlurWeights kInterleavedBlurWeights = {1.0f / 32, 2.0f / 32, 3.0f / 32, 4.0f / 32,
                                                        4.0f / 32, 4.0f / 32, 4.0f / 32, 4.0f / 32,
                                                        3.0f / 32, 2.0f / 32, 1.0f / 32};

Denoiser bilateral_denoiser(const BlurSettings& defaults);

}  // namespace crevice
