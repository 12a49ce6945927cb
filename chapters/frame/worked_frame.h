// A frame with what its passes worked on: for who asks why one of its pixels is as it is, and for the next frame, which need
// not find again what has not changed.
#pragma once

#include <memory>
#include <optional>

#include "chapters/frame/frame.h"
#include "chapters/frame/kept_passes.h"
#include "ssao/light/lit_explanation.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

struct WorkedFrame {
    Frame frame;  // but for ao_raw, which is raw.ao until show() brings it there
    ScreenGeometry geometry;
    RawAo raw;               // with its history; empty where AO was left out
    Image<float> at_pixels;  // the map as the lit pass read it; empty: the denoised one as it is
    std::shared_ptr<const ShadowMap> shadow;  // null where none was needed
    std::shared_ptr<const RayScene> rays;     // of this frame's eye; of methods that cast them
    std::shared_ptr<const VertexAo> baked;    // of methods that bake
    FarVertices far_vertices;                 // of this scene, and the last length that was asked for
    std::optional<FrameInputs> inputs;        // that all this was made of; none: there was no frame
    // Passes whose finding is that of the frame before: they did not run, or, the sky alone, only copied.
    std::vector<std::string> unchanged;
};

// The frame that render_frame() returns, before that lets go of the rest. `before` is another frame of the same scene, its
// lights aside: what would be found again is taken over from it, and WorkedFrame::unchanged says what that was. Every image is
// the same as without, to the last bit; Frame::passes and ::skipped tell of the passes that ran.
WorkedFrame worked_frame(const Scene& scene, const Camera& camera, const FrameRequest& request,
                         const AoHistory& last = {}, WorkedFrame before = {});
// Of a frame before another one, what that may take over; all else is empty, but the rays, which know their eye, and
// the far vertices, which know their length.
WorkedFrame taken_over(WorkedFrame before, const KeptPasses& kept);
// Brings into worked.frame what render_frame() returns. `worked` can still be the frame before another one.
void show(WorkedFrame& worked, const FrameRequest& request);

// The AO map that its lit pass reads, of its own size or, with a lookup of another kind, at picture size; empty: all open.
const Image<float>& lit_map(const WorkedFrame& worked);

}  // namespace crevice
