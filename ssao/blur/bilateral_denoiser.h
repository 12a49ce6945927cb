// The tutorials' blur as the denoiser of a method.
#pragma once

#include "ssao/blur/bilateral_blur.h"
#include "ssao/methods/method.h"

namespace crevice {

// Its settings are BlurSettings, but that it stores its maps as the raw map is stored.
Denoiser bilateral_denoiser(const BlurSettings& defaults);

}  // namespace crevice
