// The exponents of a sweep: how fast errors fall with samples, and how times grow with what the plan varies.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "chapters/study/statistics.h"
#include "chapters/sweep/sweep_figures.h"

namespace crevice {

// Settings of one method that differ in one thing alone.
struct FittedSeries {
    std::string method;
    std::string rest;       // what they have in common, in words
    std::vector<double> x;  // ascending
    std::vector<BarFigure> y;
    std::vector<std::string> points;  // names in the page
    // y = factor x^exponent. Only of points above 0; none with fewer than two of them.
    std::optional<PowerLaw> law;
};

// RMSE against the parameter `samples`, one series a method and rest of the setting that has at least two numbers of samples.
std::vector<FittedSeries> convergence(const ViewFigures& view);

// What a time may depend on.
struct CostVariable {
    const char* name;  // "pixels"
    const char* axis;
};
inline constexpr CostVariable kCostVariables[] = {{"pixels", "pixels of the picture"},
                                                  {"triangles", "triangles of the scene"},
                                                  {"samples", "samples a pixel"},
                                                  {"threads", "threads"}};

// Median ms against one of kCostVariables while all else that the plan sets stays the same (triangles: the scene with
// its camera changes). Of each method the series with the most different x, the first of equals; only those with at
// least two.
std::vector<FittedSeries> cost_series(std::span<const ViewFigures> views, const CostVariable& variable);

// "-0.482 ± 0.021"; without its error where two points leave none, "-" where there is no law.
std::string exponent_text(const std::optional<PowerLaw>& law);

}  // namespace crevice
