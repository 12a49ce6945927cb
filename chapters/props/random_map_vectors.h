// What the random map of chapter 05 holds.
#pragma once

#include "rasterizer/base/image.h"
#include "ssao/inputs/random_vectors.h"

namespace crevice {

// kRandomMapSide x kRandomMapSide vectors.
Image3 as_image(const RandomMap& map);

// The share of the map's vectors that are longer or shorter than 1 by more than a twentieth.
double not_unit_share(const RandomMap& map);

}  // namespace crevice
