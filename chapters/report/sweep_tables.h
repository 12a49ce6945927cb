// The tables of a sweep's report.
#pragma once

#include <span>

#include "chapters/notebook/cells.h"
#include "chapters/report/power_fits.h"
#include "chapters/study/error_points.h"
#include "chapters/sweep/sweep_figures.h"

namespace crevice {

// What each method reaches within the lab's budgets, and how long it takes to the lab's errors (error_points.h).
TableOutput equal_time_output(std::span<const ErrorPoint> points);
TableOutput equal_error_output(std::span<const ErrorPoint> points);

// One row a point of the page: all figures of a setting at a number of threads, with the commands that make them.
TableOutput points_table(const ViewFigures& view);

// Every pass of every timed setting.
TableOutput passes_table(const ViewFigures& view);

// The exponents of RMSE against samples.
TableOutput convergence_table(std::span<const FittedSeries> series);

// Between which bounds lies what more samples would leave of each method's error, and which term makes it; what each
// term has alone, and its share in the error of the frame.
TableOutput floors_table(const ViewFigures& view);

// One row a method, one column a variable of kCostVariables: the exponent, and along what; "not varied by this plan"
// where the plan holds it still.
TableOutput cost_table(std::span<const ViewFigures> views, std::span<const std::string> methods);

}  // namespace crevice
