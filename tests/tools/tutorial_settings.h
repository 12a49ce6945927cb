// The settings behind the rows of the tutorials' methods, by their members.
#pragma once

#include "chapters/frame/frame_settings.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/methods/luna_settings.h"

namespace crevice {

inline LunaSettings& ao_of(MethodSettings& settings) { return settings.ao.as<LunaSettings>(); }
inline LunaSettings& ao_of(FrameSettings& settings) { return ao_of(settings.method); }
inline const LunaSettings& ao_of(const FrameSettings& settings) {
    return settings.method.ao.as<LunaSettings>();
}
inline BlurSettings& blur_of(FrameSettings& settings) { return settings.method.denoiser.as<BlurSettings>(); }
inline const BlurSettings& blur_of(const FrameSettings& settings) {
    return settings.method.denoiser.as<BlurSettings>();
}

}  // namespace crevice
