// What the passes over an AO map yield: the map, and what they decided for each of its tiles.
#pragma once

#include "rasterizer/base/tile_map.h"
#include "rasterizer/lanes/half.h"
#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// Accessibility in [0,1], 1 = open; background 1.
struct AoMap {
    Image<float> ao;
    TileMap tiles;  // which of them were computed, are background, or are open whatever one computes
};

// A method's own map before it is denoised, with all that its denoiser reads.
struct RawAo {
    Image<float> ao;
    TileMap tiles;
    AoInputs inputs;                              // what the map's texels see
    BufferFormat format = BufferFormat::float32;  // how the map is stored
};

}  // namespace crevice
