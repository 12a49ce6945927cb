// The samples of a texel from the side, flipped to the front of its surface.
#pragma once

#include <string>
#include <vector>

#include "ssao/inputs/ao_inputs.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// The vertical plane through texel (x, y): its samples blue, and dashed where those came from that have been flipped,
// which `facing` says, d . n of each sample before; the dotted circle is the radius (scene units).
std::string flipped_samples_diagram(const AoInputs& inputs, int x, int y, const Explanation& texel,
                                    double radius, const std::vector<float>& facing,
                                    const std::string& title);

}  // namespace crevice
