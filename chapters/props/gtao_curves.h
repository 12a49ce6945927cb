// The curves of chapter 18: a floor under a ball, and what a slice keeps.
#pragma once

#include <string>

#include "chapters/notebook/plot.h"
#include "chapters/props/judged_view.h"

namespace crevice {

// Means over rings of the floor around the place where the ball of sphere_on_plane touches it, one ring each fifth of
// its radius.
PlotCurve over_distance(const std::string& name, const JudgedView& view, const Image<float>& ao,
                        PlotStyle style);

// Between two such curves.
struct Gap {
    double most = 0, mean = 0;
};
Gap gap_between(const PlotCurve& a, const PlotCurve& b);

// What the positive side of a slice keeps up to each horizon (degrees); gamma in radians.
PlotCurve kept_curve(const std::string& name, double gamma);

}  // namespace crevice
