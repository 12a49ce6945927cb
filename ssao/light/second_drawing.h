// The scene drawn again for its lights, where the first pass did not keep what the pixels show.
#pragma once

#include <vector>

#include "rasterizer/draw/normal_depth.h"
#include "ssao/light/light_tile.h"

namespace crevice {

// The parts of the geometry's tiles that are drawn again; empty where none is. See lit_tiles() in shade.h.
using PartsOfTiles = std::vector<PixelRect>;
PartsOfTiles parts_drawn_again(const Scene& scene, const ScreenGeometry& geometry, const GBuffer& gbuffer,
                               const Run& run);

// Draws and lights them; `parts` null: all tiles, wholly. Writes lighting.lit there. Without `cutouts`
// surfaces with holes are drawn whole.
void draw_again(const TileLighting& lighting, const DepthBuffer& depth, DepthFunction test, bool cutouts,
                const PartsOfTiles* parts, const Run& run);

}  // namespace crevice
