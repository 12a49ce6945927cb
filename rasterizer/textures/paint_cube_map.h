// A cube map painted a row of texels at a time: by kernels, several texels at once.
#pragma once

#include <functional>

#include "rasterizer/textures/cube_map.h"

namespace crevice {

// A row of a face, with room for whole groups of lanes behind its texels.
struct CubeRow {
    int count;                  // texels
    const float* direction[3];  // unit, through each texel's centre
    float* rgb[3];              // linear light, to be written
};

// As build_cube_map, of what `paint` writes into each row, on all threads.
CubeMap paint_cube_map(int side, const std::function<void(const CubeRow& row)>& paint, const Run& run = {});

}  // namespace crevice
