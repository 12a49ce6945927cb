// Error over what a picture's pixel asks, of a method and of rays: for chapter 21.
#pragma once

#include <vector>

#include "chapters/notebook/plot.h"
#include "chapters/study/error_study.h"

namespace crevice {

// The settings that the curves need, on pictures of half `size` each way (rays for every pixel are many), at least 160 by 90.
ErrorPlan cost_plan(Size size, int seeds);

// RMSE against T over samples, or rays, a pixel of the picture; `raw` and `blurred` at full size.
struct CostCurves {
    PlotCurve raw, blurred, half, cast;
};
CostCurves cost_curves(const ErrorStudy& study);

// The points that no other beats: none asks less and errs less.
PlotCurve front_of(const std::vector<PlotCurve>& curves);

}  // namespace crevice
