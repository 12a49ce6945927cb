// Where a surface ends between a texel and its neighbours, found once and packed into two bits a side.
// Source: XeGTAO 1.30 (Intel), XeGTAO_CalculateEdges and XeGTAO_PackEdges
// In:     AoInputs::view_depth
// Out:    for each side whether the neighbour continues the texel's depth, or the slope from the other neighbour to it:
//         full up to a quarter of 1.1 % of the depth, none from five quarters of it on
// Differs from the source: the map ends where it ends, and the background is no neighbour. In orthographic pictures,
//         whose depths tell nothing about the size of a texel, the width follows the height of the view.
#pragma once

#include <algorithm>
#include <cstdint>

#include "rasterizer/base/run.h"
#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// XeGTAO's: depths of one surface differ less than this share of the depth.
inline constexpr float kEdgeShare = 0.011f;

// How far each texel's surface goes on: 3 to the next texel, 0 not at all. Texel (x, y) of the map is at
// (x + 1, y + 1), and around the map there is nothing.
struct PackedEdges {
    static constexpr int kLeft = 6, kRight = 4, kTop = 2, kBottom = 0;  // the first of two bits
    static constexpr int kSurface = 1 << 8;                             // set: the texel shows something
    Image<std::int32_t> bits;

    // As it is packed, from 0 to 3.
    int at(int x, int y, int side) const { return (bits.at(x + 1, y + 1) >> side) & 3; }
};
PackedEdges packed_edges(const AoInputs& inputs, const Run& run = {});

// A map with one texel more all around, in whole groups of pixels.
template <class T>
Image<T> with_apron(const Image<T>& map, T beyond) {
    Image<T> result({round_up(map.size.width, kRowAlignment) + 2, map.size.height + 2}, beyond);
    for (int y = 0; y < map.size.height; ++y) std::copy_n(map.row(y), map.size.width, result.row(y + 1) + 1);
    return result;
}

}  // namespace crevice
