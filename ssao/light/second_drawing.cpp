#include "ssao/light/second_drawing.h"

#include <algorithm>

namespace crevice {

SecondDrawing second_drawing(const ScreenGeometry& geometry, const GBuffer& gbuffer, const Holes& holes,
                             const Run& run) {
    const auto tiles = static_cast<std::size_t>(geometry.tile_count());
    const bool knows_triangles = !gbuffer.triangle.empty() && gbuffer.tiles.size() == tiles;
    SecondDrawing second{{}, std::vector<PixelRect>(tiles)};
    for (std::size_t i = 0; i < tiles; ++i) {
        const int tile = static_cast<int>(i);
        if (geometry.triangles_of_tile(tile) == 0 && run.leaves_out(Skip::empty_tiles)) continue;
        second.drawn[i] = knows_triangles && run.leaves_out(Skip::second_drawing) ? gbuffer.tiles[i].tied
                                                                                  : geometry.tile_rect(tile);
    }
    const bool any_drawn = std::any_of(second.drawn.begin(), second.drawn.end(),
                                       [](const PixelRect& part) { return !part.empty(); });
    if (!any_drawn) return second;
    Image<std::int32_t> known =
        knows_triangles ? gbuffer.triangle : Image<std::int32_t>(geometry.size, kNoTriangle);
    second.triangle = drawn_again(std::move(known), second.drawn, geometry, gbuffer.depth,
                                  DepthFunction::equal, holes, run);
    return second;
}

}  // namespace crevice
