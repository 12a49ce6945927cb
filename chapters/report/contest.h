// Who wins on one view: the least error within a time, and the least time within an error, and who ties with the winner.
#pragma once

#include <vector>

#include "chapters/sweep/sweep_figures.h"

namespace crevice {

// A setting with errors, and its time where times are compared.
struct Contestant {
    const SettingFigures* figures = nullptr;
    const SettingTime* time = nullptr;

    const std::string& method() const { return figures->setting.method; }
    const SettingErrors& errors() const { return *figures->errors; }
    double rmse() const { return errors().rmse.value; }
    double ms() const { return time->ms.value; }
};

// The settings with errors and a time on so many threads; whatever the times where `threads` is 0.
std::vector<Contestant> contestants(const ViewFigures& view, int threads);

// The best setting of each method: the winner, who ties with it, then the others.
struct Contest {
    std::vector<Contestant> ranking;
    std::size_t ties = 0;  // so many of them, from the first, cannot be told from the winner; 1: only itself

    bool won() const { return ties == 1; }
};

// By RMSE, then time. Ties: the difference lies within its 95 % interval.
Contest least_error(const std::vector<Contestant>& all);
// Of those that keep the budget.
Contest least_error_within(std::vector<Contestant> all, double budget_ms);
// By time, of those with no larger RMSE. Ties: the ratio lies within that of a setting timed twice (A/A), or the
// intervals of the two times meet.
Contest least_time_to(std::vector<Contestant> all, double rmse, const std::optional<BarFigure>& same_again);

}  // namespace crevice
