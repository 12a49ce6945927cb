// The second drawing of a frame, which lights what the first one found: the picture, and one of its pixels in numbers.
#pragma once

#include "chapters/frame/worked_frame.h"
#include "ssao/light/shade.h"

namespace crevice {

// `geometry`, the frame's G-buffer and `ao` are the first drawing's; `texel_normals` those of the AO map's texels, where
// bent normals are read; `shadow` may be null. The sky is not drawn yet.
LitImage lit_image(const Scene& scene, const ScreenGeometry& geometry, const Frame& frame,
                   const Image<float>& ao, const Image3& texel_normals, const ShadowMap* shadow,
                   const FrameRequest& request);

// A pixel of the lit image in numbers: what render_frame() lights it with, sky and all. `request` wants "lit".
LitExplanation explain_lit(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x,
                           int y);

}  // namespace crevice
