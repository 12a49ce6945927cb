// The taps of the blur at an edge, in a cut through the depth buffer along the row of a texel.
#pragma once

#include <string>
#include <vector>

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// A neighbour on the row of a texel, and whether the mean takes it.
struct BlurTap {
    int x = 0;
    bool counts = false;
};

// Texel (x, y) green, the taps that count blue, the others red, each where the eye sees its surface. All taps have one.
std::string blur_taps_diagram(const AoInputs& inputs, int x, int y, const std::vector<BlurTap>& taps,
                              const std::string& title);

}  // namespace crevice
