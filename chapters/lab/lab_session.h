// What a lab does while somebody looks: draws frames, tells of a pixel, and refines truth, each from what it still has.
#pragma once

#include <optional>
#include <string>

#include "chapters/frame/worked_frame.h"
#include "chapters/lab/frame_reply.h"
#include "chapters/lab/progressive_truth.h"
#include "chapters/probe/pixel_probe.h"

namespace crevice {

// Of the AO that the lit pass reads against rays, after so many from each pixel. The error is none, and the images are
// empty or those of before, until there are two passes and the present one is complete.
struct TruthSoFar {
    bool complete = false;  // the pass that was going on has ended
    int rays = 0;           // of complete passes, a pixel
    double rmse = 0, bias = 0;
    const ReferenceImage* reference = nullptr;
    const Image<float>* ao_error = nullptr;  // AO - reference, picture size
};

class LabSession {
 public:
    explicit LabSession(const Run& run = {}) : run_(run) {}

    // Reads or makes the scene where it is not at hand. Throw UsageError and InputError, as `crevice render` does.
    const LoadedScene& scene(const LabWords& words, bool surfaces);
    const DrawnFrame& draw(const LabWords& words);

    // Of the frame that was drawn last; `probe` and `cast_truth` throw UsageError where there is none.
    PixelProbe probe(int x, int y);
    // Casts some 30 ms of rays more. Throws UsageError for a method without AO.
    TruthSoFar cast_truth();

 private:
    const WorkedFrame& worked();

    Run run_;
    std::optional<LoadedScene> scene_;
    WorkedFrame before_;  // of that scene: the last frame, while the next one is still to be drawn
    std::optional<DrawnFrame> drawn_;
    bool has_all_ = false;                   // all buffers, as soon as somebody asks about a pixel of it
    std::optional<ProgressiveTruth> truth_;  // of what was drawn
    ReferenceImage reference_;               // as it was told last
    Image<float> ao_, ao_error_;             // the AO that is judged, picture size, and how far it is off
};

}  // namespace crevice
