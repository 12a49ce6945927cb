// The panels of `crevice view`, by Dear ImGui: between its NewFrame and Render.
#pragma once

#include "chapters/view/view_state.h"

namespace crevice {

// Width of the panel at the left, pixels; the picture has the rest.
inline constexpr float kPanel_px = 360;

// Scene, method, parameters, buffers, and what the newest frame tells: times, warnings, what was left out. `newest` null:
// there is none yet.
void draw_controls(ViewState& state, const ViewFrame* newest);

// What is known of the pixel that is asked about, over the lower part of the picture.
void draw_probe(const ViewFrame& newest);

}  // namespace crevice
