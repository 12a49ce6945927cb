// Holes in surfaces: fragments whose texture's alpha is below the material's cutoff, dropped the same way in
// every pass of a view.
// Source: X_Jun, which calls clip(alpha - 0.1) in its normal, shadow and lit passes
#pragma once

#include "rasterizer/draw/visibility.h"

namespace crevice {

bool has_cutouts(const Material& material);
bool has_cutouts(const Scene& scene);

// Those of the scene's materials; empty when there are none. Scene and geometry must outlive it; `run` is that
// of the drawing.
Holes alpha_holes(const Scene& scene, const ScreenGeometry& geometry, const Run& run);

}  // namespace crevice
