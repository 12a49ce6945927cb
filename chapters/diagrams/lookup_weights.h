// How a pixel of the picture reads the AO map: the four texels around its centre and their weights.
#pragma once

#include <array>
#include <string>

#include "rasterizer/base/image.h"

namespace crevice {

struct TexelWeight {
    int x = 0, y = 0;  // of the texel
    float weight = 0;
};

// As a linear sampler with clamped edges weighs them; upper left, upper right, lower left, lower right.
std::array<TexelWeight, 4> lookup_weights(Size map, Size picture, int x, int y);

// The four texels as squares with their accessibility, the pixel green, and the weights beside the lines that join them.
std::string lookup_diagram(const Image<float>& ao, Size picture, int x, int y, const std::string& title);

}  // namespace crevice
