// Where in the AO map the lit pass looks: right, or as seed 000's vertex shader has it.
//
// It adds (w, w) to clip x and y before scaling by (1/2, -1/2), where (w, -w) is right: v comes out too small by exactly
// 1. A sampler that wraps finds the right row all the same, so nobody noticed; one that clamps reads the top row
// everywhere. (The repository was mended in 2022.)
#pragma once

#include "rasterizer/image.h"

namespace crevice {

enum class AoLookup {
    exact,
    slip_wrap,   // v - 1, WRAP: as if nothing were wrong
    slip_clamp,  // v - 1, CLAMP: the top row for every pixel
};

// The map as the lit pass finds it.
Image<float> looked_up(Image<float> ao, AoLookup lookup);

}  // namespace crevice
