// Mip levels of a cut-out that keep as much of it as the full size shows.
#pragma once

#include "rasterizer/textures/texture.h"

namespace crevice {

// The part of an alpha plane that passes an alpha test, alpha >= threshold: [0,1].
double coverage(const Image<float>& alpha, float threshold);

// The mean of alpha keeps its sum, not what an alpha test lets through: under a threshold above the mean a
// fence dissolves with distance, under one below the mean (the tutorials clip at 0.1) it grows into a wall. Here
// the alpha of every smaller level is scaled, and cut at 1, so that the same part of its texels passes as at full
// size (Castano 2010, "Computing alpha mipmaps"), as nearly as texels of equal alpha, which pass together, allow:
// at the smallest levels it is all or nothing. Between texels alpha is filtered as ever, so an outline still moves
// by up to half a texel of its level. Does nothing without alpha. Throws UsageError unless 0 < threshold <= 1.
Texture keep_coverage(const Texture& texture, float threshold);

}  // namespace crevice
