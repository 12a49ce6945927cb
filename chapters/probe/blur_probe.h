// The AO texel that a pixel lies in, pass by pass of the denoiser.
#pragma once

#include <string>
#include <vector>

#include "chapters/probe/ao_probe.h"

namespace crevice {

struct BlurProbe {
    std::string left_out;  // why nothing was blurred; empty: it was
    // In their order. The value that the last one writes is `value`; those before it write what it reads.
    std::vector<ExplainedPass> passes;
    float value = 1;  // of the texel in the denoised map; where nothing was blurred in the raw one
};

// `ao` is of the same pixel.
BlurProbe probe_blur(const FrameRequest& request, const WorkedFrame& worked, const AoProbe& ao);

}  // namespace crevice
