// The AO texel that a pixel lies in, sample by sample.
#pragma once

#include <string>
#include <vector>

#include "chapters/frame/worked_frame.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// A pixel of the picture around a texel's centre. At full size there is one, the texel itself.
struct TexelPixel {
    int x = 0, y = 0;
    float weight = 0;      // with which a linear filter reads it at the centre, [0,1]
    float view_depth = 0;  // scene units; background +inf
};

struct AoProbe {
    std::string left_out;  // why no AO was computed; empty: it was
    int x = 0, y = 0;      // the texel that holds the pixel's centre
    Size map_size;         // of the AO map, texels
    std::vector<TexelPixel> pixels;
    // The samples; their contributions added in their order from 0 on are `sum`, and value_of_sum(sum) is `value`.
    Explanation explanation;
    float sum = 0;
    float value = 1;  // of the texel in the raw map, 1 = open; background and where AO was left out 1
};

AoProbe probe_ao(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x, int y);

}  // namespace crevice
