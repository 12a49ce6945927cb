// What goes wrong between a map and what reads it: half a texel, and a row. For chapter 11.
#pragma once

#include "rasterizer/scene/scene.h"

namespace crevice {

// A bare floor at half size: with the depth of each texel's centre, and with that of its upper left pixel.
struct MisplacedFloor {
    Image<float> exact, misplaced;
};
MisplacedFloor misplaced_floor();

// An AO map of the house's eaves as the lit pass reads it at v, and at v - 1 as X_Jun's vertex shader has it:
// (y + w) * -0.5 / w instead of (y - w) * -0.5 / w.
struct ShiftedRows {
    Image<float> wrap, wrap_off, clamp_off;
    float apart = 0;           // the largest difference of the first two
    float apart_if_exact = 0;  // the same at a size where v - 1 is no rounded number
    float from_top_row = 0;    // of clamp_off from its own top row, repeated
    float mixed_rim = 0,
          mixed_inside = 0;  // of WRAP from CLAMP at v, in the top row and in all but the outermost rows
};
ShiftedRows shifted_rows(const Scene& columns);

}  // namespace crevice
