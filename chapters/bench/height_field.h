// A scene of as many triangles as one likes, for `crevice bench --scale`.
#pragma once

#include <cstdint>

#include "rasterizer/scene/scene.h"

namespace crevice {

// Smooth random hills, 20 scene units square, around the origin: across x down cells of two triangles each,
// seen so that they fill a wide picture. The hills are those of the seed, whatever the number of cells.
// Throws UsageError unless both counts are in 1..kMostCells.
inline constexpr int kMostCells = 10000;
Scene height_field_scene(int across, int down, std::uint32_t seed = 1);

}  // namespace crevice
