// What is known of a tile before it is computed, drawn and painted, and what rules that prove nothing make of it: for chapter
// 23.
#pragma once

#include <string>

#include "chapters/notebook/picture.h"
#include "rasterizer/scene/scene.h"
#include "ssao/methods/open_tiles.h"

namespace crevice {

// The final image, with the tiles that a pass left out painted over; their edges show the tile size.
Picture painted(const Image3& lit, const TileMap& map);

// Crates on a floor, seen from right above: the floor is level, and dark around each crate. A small picture is taken from
// nearer, so that a tile of it fits between them.
Scene crates_from_above(Size picture);

// Naive: a tile is called open when its own texels lie within epsilon, whatever stands beside it.
TileMap own_depths_only(const AoInputs& inputs, const LunaSettings& settings);
// Naive: a tile is called background when its four corners show none.
TileMap corners_only(const AoInputs& inputs);

// The map with the tiles that were left out at 1.
Image<float> with_ones(Image<float> ao, const TileMap& map);

// Texels of one tile, the end not included.
struct TileTexels {
    int x0, y0, x1, y1;
};
// The darkest texel of all tiles that the naive rule takes and the right one does not.
struct HarmedTexel {
    int x = 0, y = 0;
    TileTexels tile{};
};
HarmedTexel most_harmed(const TileMap& naive, const TileMap& right, const Image<float>& ao);

// A cut through that tile, along the row or the column of texels on which something nearer lies: the tile, how far its
// samples look, and the depth in front of which something must lie to count.
std::string tile_diagram(const AoInputs& inputs, const LunaSettings& settings, const HarmedTexel& texel);

}  // namespace crevice
