#include "chapters/report/contest.h"

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

bool same_error(const Contestant& a, const Contestant& b) {
    return std::fabs(a.rmse() - b.rmse()) <= std::hypot(a.errors().rmse_margin(), b.errors().rmse_margin());
}

bool same_time(const BarFigure& a, const BarFigure& b, const std::optional<BarFigure>& same_again) {
    if (a.low <= b.high && b.low <= a.high) return true;
    if (!same_again) return false;
    const double ratio = std::max(a.value / b.value, b.value / a.value);
    return ratio <= std::max(same_again->high, 1 / same_again->low);
}

bool less_error(const Contestant& a, const Contestant& b) {
    if (a.rmse() != b.rmse()) return a.rmse() < b.rmse();
    return a.time != nullptr && b.time != nullptr && a.ms() < b.ms();
}

bool less_time(const Contestant& a, const Contestant& b) { return a.ms() < b.ms(); }

// Each method's first by `before`, in that order, but those that are the same as the first of all before the others.
template <class Before, class Same>
Contest contest(std::vector<Contestant> all, const Before& before, const Same& same) {
    std::stable_sort(all.begin(), all.end(), before);
    Contest result;
    for (const Contestant& one : all) {
        const bool known =
            std::any_of(result.ranking.begin(), result.ranking.end(),
                        [&](const Contestant& other) { return other.method() == one.method(); });
        if (!known) result.ranking.push_back(one);
    }
    if (result.ranking.empty()) return result;
    // One that is less sure may tie behind one that does not.
    const Contestant first = result.ranking.front();
    const auto rest = std::stable_partition(result.ranking.begin(), result.ranking.end(),
                                            [&](const Contestant& one) { return same(first, one); });
    result.ties = static_cast<std::size_t>(rest - result.ranking.begin());
    return result;
}

}  // namespace

std::vector<Contestant> contestants(const ViewFigures& view, int threads) {
    std::vector<Contestant> all;
    for (const SettingFigures& figures : view.settings) {
        const SettingTime* const time = figures.time(threads);
        if (figures.errors && (threads == 0 || time != nullptr)) all.push_back({&figures, time});
    }
    return all;
}

Contest least_error(const std::vector<Contestant>& all) { return contest(all, less_error, same_error); }

Contest least_error_within(std::vector<Contestant> all, double budget_ms) {
    std::erase_if(all, [&](const Contestant& one) { return one.ms() > budget_ms; });
    return least_error(all);
}

Contest least_time_to(std::vector<Contestant> all, double rmse, const std::optional<BarFigure>& same_again) {
    std::erase_if(all, [&](const Contestant& one) { return one.rmse() > rmse; });
    return contest(all, less_time, [&](const Contestant& a, const Contestant& b) {
        return same_time(a.time->ms, b.time->ms, same_again);
    });
}

}  // namespace crevice
