// The four pixels that a texel of a half-size map lies among: what they show, and what the texel takes from them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "chapters/props/switched_ao.h"
#include "ssao/inputs/linear_taps.h"

namespace crevice {

// Those of each texel, row by row.
struct PixelsAround {
    LinearTaps columns, rows;

    explicit PixelsAround(const AoInputs& inputs);
    std::array<Texel, 4> of(const Texel& at) const;
};

// Two maps of one view, whose edge texels take the nearest surface and the mean of the four: where the depths are farthest
// apart, all four pixels showing something.
Texel most_mixed(const SwitchedAo& nearest, const SwitchedAo& mixed);

// A row for each of the four pixels of a texel, one for their mean, one for the texel: name, normal, view depth.
std::vector<std::vector<std::string>> pixel_rows(const Texel& at, const SwitchedAo& nearest,
                                                 const SwitchedAo& mixed);

// The texels whose four pixels all show the sky.
struct SkyTexels {
    int count = 0, darkened = 0;  // darkened: accessibility other than 1
};
SkyTexels sky_texels(const SwitchedAo& shown);

}  // namespace crevice
