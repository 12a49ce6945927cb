// A frame with what its passes worked on: for who asks why one of its pixels is as it is.
#pragma once

#include <memory>

#include "chapters/frame/frame.h"
#include "ssao/light/lit_explanation.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

struct WorkedFrame {
    Frame frame;  // but for ao_raw, which is raw.ao
    ScreenGeometry geometry;
    RawAo raw;               // with its history; empty where AO was left out
    Image<float> at_pixels;  // the map as the lit pass read it; empty: the denoised one as it is
    std::shared_ptr<const ShadowMap> shadow;  // null where none was needed
    std::shared_ptr<const RayScene> rays;     // of methods that cast them
    std::shared_ptr<const VertexAo> baked;    // of methods that bake
};

// What an earlier frame of the same scene, its lights and all, has left: taken over where it is what this frame would make
// anew, the shadow always, the rays from the same eye.
struct AtRest {
    std::shared_ptr<const ShadowMap> shadow;
    std::shared_ptr<const RayScene> rays;
};

// The frame that render_frame() returns, before that lets go of the rest.
WorkedFrame worked_frame(const Scene& scene, const Camera& camera, const FrameRequest& request,
                         const AoHistory& last = {}, const AtRest& at_rest = {});
// And that frame alone.
Frame frame_of(WorkedFrame worked, const FrameRequest& request);

// The AO map that its lit pass reads, of its own size or, with a lookup of another kind, at picture size; empty: all open.
const Image<float>& lit_map(const WorkedFrame& worked);

// A pixel of its lit image in numbers: what render_frame() lights it with, sky and all. `request` wants "lit".
LitExplanation explain_lit(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x,
                           int y);

}  // namespace crevice
