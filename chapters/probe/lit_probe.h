// What lights a pixel: the terms of each light, the shadow, and the AO that the ambient terms are multiplied by.
#pragma once

#include <vector>

#include "chapters/frame/worked_frame.h"

namespace crevice {

// A texel of the AO map, as the lit pass's linear filter reads it at the pixel's centre.
struct ReadTexel {
    int x = 0, y = 0;
    float weight = 0;  // [0,1]
    float value = 1;   // accessibility
};

struct LitProbe {
    LitExplanation explanation;
    // Around the pixel; none without an AO map, or with another lookup than the linear one.
    std::vector<ReadTexel> texels;
};

LitProbe probe_lit(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x, int y);

}  // namespace crevice
