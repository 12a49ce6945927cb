// The scene of chapter 19, and what the bitmask's thickness does to its error.
#pragma once

#include <string>

#include "chapters/notebook/plot.h"
#include "chapters/props/judged_view.h"

namespace crevice {

// Thin bars a unit in front of a wall.
Scene bars_before_a_wall();

// RMS errors of vbao, with these words, over thicknesses from 0.06 to 4 scene units.
struct ThicknessError {
    PlotCurve curve;
    double best = 0;  // the thickness with the least error
};
ThicknessError over_thickness(const std::string& name, const JudgedView& view, const Truth& truth,
                              const Words& words);

}  // namespace crevice
