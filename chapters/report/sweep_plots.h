// The plots of a sweep's report. Each is a file of its own, plots/NAME.svg, and stands in the page.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "chapters/notebook/cells.h"
#include "chapters/report/power_fits.h"
#include "chapters/sweep/sweep_figures.h"
#include "chapters/study/error_points.h"

namespace crevice {

// What can stand on the upright axis of error over time.
struct ErrorMeasure {
    const char* name;  // "RMSE", on the button that chooses it
    const char* file;  // "rmse"
    const char* axis;
    BarFigure SettingErrors::*figure;
    double SettingErrors::*reference_error = nullptr;  // where the reference's own noise is of the same kind
};
inline constexpr ErrorMeasure kErrorMeasures[] = {
    {"RMSE", "rmse", "RMSE against soft truth, debiased", &SettingErrors::rmse,
     &SettingErrors::reference_error},
    {"FLIP", "flip", "FLIP against soft truth, mean", &SettingErrors::flip},
    {"|bias|", "bias", "|mean difference| from soft truth", &SettingErrors::bias},
    {"p99", "p99", "99th percentile of |difference|", &SettingErrors::p99},
    {"RMSE, hard", "rmse_hard", "RMSE against hard truth, debiased", &SettingErrors::hard_rmse,
     &SettingErrors::hard_reference_error},
};

// The settings with a time at so many threads and an error; where the measure has a sign, its size.
std::vector<ErrorPoint> error_points(const ViewFigures& view, int threads, const ErrorMeasure& measure);

// Of each method the points that none of its own beats, for tables of what a method can do.
std::vector<ErrorPoint> best_of_each(std::span<const ErrorPoint> points);

// Error over time by each of kErrorMeasures: one line a method through those of its settings that none of its own beats, the
// Pareto front of all, and both noise floors.
std::vector<DrawingOutput> error_over_time(const ViewFigures& view, int threads,
                                           std::span<const std::string> methods);

// RMSE against samples: of each method the series that ends lowest.
DrawingOutput convergence_plot(const ViewFigures& view, std::span<const FittedSeries> series,
                               std::span<const std::string> methods);

// The shares of each step in the mean squared error of each method, at its setting with the most samples.
DrawingOutput error_parts_plot(const ViewFigures& view);

// Median ms against a variable, one line a method.
DrawingOutput cost_plot(const CostVariable& variable, std::span<const FittedSeries> series,
                        std::span<const std::string> methods);

}  // namespace crevice
