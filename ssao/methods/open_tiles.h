// Which tiles of an AO map need no estimator: those without a surface, and those that nothing in reach of
// their samples can occlude. There accessibility is exactly 1.
// Source: luna_occlusion.h: a sample counts only where the depth map shows a surface more than epsilon in
//         front of the sample's own texel, and looks no further than its reach.
// In:     AoInputs; only what the buffers hold is believed, the depth map's border included
// Out:    done, background or open, a tile
// Cost:   one pass over the AO map's depths; where that leaves hope, one over the depth map's rows in reach.
#pragma once

#include "rasterizer/base/tile_map.h"
#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// Side of a tile, texels of the AO map.
inline constexpr int kAoTile = 16;
static_assert(kAoTile % kMostLanes == 0);  // no group of texels lies in two

// How many radii a sample can lie away from its point. Along a random vector r that is not unit the
// reflection multiplies by |1 - 2 r^2|, and r^2 is up to 3.
inline constexpr float kUnitReach = 1, kRawReach = 5;

// How far from its texel a sample may be compared with the depth map, in pixels of the picture: the longer side,
// for a point at view_depth or further; filters and roundings not counted.
double sample_reach_px(const AoInputs& inputs, const LunaSettings& settings, double view_depth);

// done, background or open, a tile; tiles that `run` keeps are done.
TileMap ao_tiles(const AoInputs& inputs, const LunaSettings& settings, const Run& run = {});

}  // namespace crevice
