// What a method's settings cost and how wrong they are: the points of an error-against-time plot, and what
// can be read from them.
// Rule:   of settings that tie, the tables take the worse one, so that no method gains by it (as Mueller et
//         al. 2016 do against their own)
#pragma once

#include <span>
#include <string>
#include <vector>

#include "chapters/notebook/plot.h"
#include "chapters/notebook/table.h"

namespace crevice {

struct ErrorPoint {
    std::string method, setting;
    double time_ms = 0;                   // > 0, median
    double error = 0;                     // >= 0, mean over seeds
    double error_min = 0, error_max = 0;  // over seeds, or how sure it is: its bar
    double time_min = 0, time_max = 0;    // the bar of the time, ms; both 0: none
    std::string name = "";                // of its dot in the page; may be empty
};

// Indices of the points that no other point beats: none is as fast and as good, and better in one of the two.
// By time, then error, then index. Every function here throws UsageError naming a point whose numbers are
// negative or not finite, or whose time is 0.
std::vector<std::size_t> pareto_front(std::span<const ErrorPoint> points);

// One row a method, in the order they first appear; for each budget the slowest setting that keeps it, its
// time and error: "setting_5_ms", "time_5_ms", "error_5_ms". Of settings equally slow the one with the
// larger error. Nothing where no setting is fast enough.
Table equal_time_table(std::span<const ErrorPoint> points, std::span<const double> budgets_ms);

// One row a method; for each error the fastest setting that is no worse: "setting_at_0.05", "time_at_0.05"
// (ms). "not reached" where there is none.
Table equal_error_table(std::span<const ErrorPoint> points, std::span<const double> errors);

// The budgets and errors the lab reports.
inline constexpr double kBudgets_ms[] = {5, 20, 80};
inline constexpr double kErrorLevels[] = {0.05, 0.02};

// One series a method, its points by time, with their bars both ways; last the Pareto front. A point with error 0 has no place
// on a logarithmic axis and is not drawn.
std::vector<PlotCurve> error_curves(std::span<const ErrorPoint> points);

}  // namespace crevice
