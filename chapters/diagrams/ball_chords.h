// The ball of multi-scale volumetric obscurance (ssao/methods/msvo.h) around one texel.
#pragma once

#include <string>

#include "ssao/inputs/ao_inputs.h"
#include "ssao/methods/explanation.h"
#include "ssao/methods/msvo.h"

namespace crevice {

// A level cut through the depth buffer and the ball of scale `number`, 0 the smallest, with the chords of the four taps that
// lie in the cut: blue where they are in front of the surface that is seen there, red where they are behind it.
std::string ball_diagram(const AoInputs& inputs, const MsvoSettings& settings, int number, int x, int y,
                         const std::string& title);

// The taps of the smallest ball as the eye sees them, opposite ones joined: red where a pair takes something from the texel
// of the explanation, blue where it is open.
std::string tap_pairs_diagram(const Explanation& explanation, const std::string& title);

}  // namespace crevice
