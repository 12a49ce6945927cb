// What the methods of chapters 17 and 18 find along a line on the screen, over a cut through the depth buffer: the
// horizons of HBAO and GTAO. All numbers are the kernels'.
#pragma once

#include <string>

#include "ssao/inputs/ao_inputs.h"
#include "ssao/methods/explanation.h"
#include "ssao/methods/gtao.h"
#include "ssao/methods/hbao.h"

namespace crevice {

// One of a texel's directions: its samples are numbers first ... first + HbaoSettings::steps - 1 of the explanation.
std::string horizon_diagram(const AoInputs& inputs, const HbaoSettings& settings, int x, int y,
                            const Explanation& explanation, std::size_t first, const std::string& title);

// A slice of GTAO: angles are measured from v, towards the eye; all radians.
struct SliceHorizons {
    float gamma = 0;               // of the normal's part in the slice
    float before = 0, behind = 0;  // of the horizons: h_1 <= 0 on the negative side, h_2 >= 0
    float length = 0;              // of the normal's part, [0, 1]
    float lost = 0;                // what the slice takes, [0, 1]
};
SliceHorizons slice_horizons(const AoInputs& inputs, const GtaoSettings& settings, int x, int y, int number);
std::string slice_diagram(const AoInputs& inputs, const GtaoSettings& settings, int x, int y, int number,
                          const std::string& title);

}  // namespace crevice
