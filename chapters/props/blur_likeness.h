// What the blur's two tests find between a texel and its neighbours on one row.
#pragma once

#include <string>
#include <vector>

#include "chapters/diagrams/blur_taps.h"
#include "chapters/props/switched_ao.h"

namespace crevice {

inline bool inside(Size size, int x, int y) { return x >= 0 && y >= 0 && x < size.width && y < size.height; }

// Of texel (x, y) and one of its neighbours.
struct Likeness {
    float cosine, apart;  // n_c . n_i, |z_c - z_i|
    bool counts(const BlurSettings& blur) const {
        return cosine >= blur.normal_threshold && apart <= blur.depth_threshold;
    }
};
Likeness likeness(const AoInputs& inputs, int x, int y, int tap_x, int tap_y);

// A texel whose row crosses a step in depth, not too high to be drawn: some taps are rejected, and by their depth.
Texel texel_at_a_step(const AoInputs& inputs, const BlurSettings& blur);

// The eleven taps on the row of a texel: for the diagram; as rows, {i, weight, cosine, difference in depth, verdict, AO};
// and the weights of those that count together.
struct TapsOfTexel {
    std::vector<BlurTap> taps;
    std::vector<std::vector<std::string>> rows;
    double kept_weight = 0;
};
TapsOfTexel taps_of(const AoInputs& inputs, const Image<float>& ao, const BlurSettings& blur, Texel texel);

}  // namespace crevice
