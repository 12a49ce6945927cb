// One frame of the tutorials' pipeline: the passes in their order, each timed.
#pragma once

#include <string>
#include <vector>

#include "chapters/frame/frame_settings.h"
#include "chapters/frame/left_out.h"
#include "chapters/frame/precision_account.h"
#include "chapters/terminal/stopwatch.h"
#include "ssao/needs.h"

namespace crevice {

struct FrameRequest {
    Size size;
    const Method* method = nullptr;
    FrameSettings settings;
    WantedBuffers wanted = all_buffers();
    int repeats = 1;  // >= 1; times are medians over them
    Run run;
};

struct Frame {
    Camera camera;  // as drawn: with the depth direction that the settings asked for
    GBuffer gbuffer;
    Image<float> ao_raw, ao_blurred;  // empty when left out; raw: with its history
    Image3 bent_normal;               // AO map size; empty when neither asked for nor read by the light
    Image3 lit;                       // empty when left out
    // Those that ran, and last "frame": all that makes the pictures. The time of the account below is not in it, for it makes
    // none and is taken once, however often the frame is repeated: less than a hundredth of the tutorials' frames, three of the
    // first one of a million triangles, and another drawing where depths are too coarse or reach the cleared one.
    std::vector<PassTime> passes;
    std::vector<LeftOut> left_out;  // passes and data, with reasons
    FrameTiles tiles;
    std::vector<SkippedWork> skipped;  // by the passes that ran
    std::vector<PrecisionLoss> precision;
    AoHistory history;  // for the next frame; empty where the settings ask for none
};

// `last` is what the frame before left; empty for the first one.
Frame render_frame(const Scene& scene, const Camera& camera, const FrameRequest& request,
                   const AoHistory& last = {});

}  // namespace crevice
