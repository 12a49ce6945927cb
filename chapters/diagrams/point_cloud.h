// The points that a method throws around one texel, in a cut through the depth buffer.
#pragma once

#include <string>

#include "ssao/inputs/ao_inputs.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// The cut contains the eye's ray through texel (x, y) and q of the sample `through`. Of the texel's samples it shows the
// points q that lie near its plane: red dots those that take something, blue rings the others. The half circle of `radius`
// scene units over p lies on the side of n.
std::string hemisphere_diagram(const AoInputs& inputs, int x, int y, const Explanation& explanation,
                               std::size_t through, double radius, const std::string& title);

// The index of the sample that takes most; the first of those that take the same.
std::size_t strongest_sample(const Explanation& explanation);

}  // namespace crevice
