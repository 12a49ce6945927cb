// The time that leaving out saves: frames with and without a kind of work, in turns.
#pragma once

#include "chapters/frame/frame.h"
#include "chapters/study/statistics.h"

namespace crevice {

struct Saving {
    Skip skip;
    MedianInterval saved_ms;  // wall time of the frame with this kind of work kept, minus that without
};

// `pairs` >= 1 pairs of frames for each of these kinds, in their order. A progress bar on a terminal.
std::vector<Saving> measure_savings(const Scene& scene, const Camera& camera, const FrameRequest& request,
                                    const std::vector<Skip>& kinds, int pairs);

}  // namespace crevice
