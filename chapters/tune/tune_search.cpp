#include "chapters/tune/tune_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crevice {

namespace {

constexpr std::size_t kSettings = 64;    // of the first rung, the defaults among them
constexpr std::size_t kKept = 4;         // of each rung the best out of so many go on
constexpr double kFirstStep = 0.2;       // of an axis
constexpr double kSmallestStep = 0.04;   // below it two settings could not be told apart
constexpr int kMostRounds = 4;           // over all axes
constexpr double kNoDifference = 0.002;  // of the error, or of the time

// Times that lie in one step of these cannot be told apart.
double time_step(double ms) {
    constexpr double kStep = 1.05;
    return std::floor(std::log(ms) / std::log(kStep));
}

// The root above 1 of x^(d + 1) = x + 1.
double roberts_base(std::size_t dimensions) {
    double x = 2;
    for (int i = 0; i < 64; ++i) x = std::pow(1 + x, 1 / (static_cast<double>(dimensions) + 1));
    return x;
}

std::vector<TuneSetting> spread_settings(const std::vector<TuneAxis>& axes, std::size_t count) {
    const double base = roberts_base(axes.size());
    std::vector<TuneSetting> settings;
    for (std::size_t n = 1; n <= count; ++n) {
        TuneSetting setting;
        double power = 1;
        for (const TuneAxis& axis : axes) {
            power /= base;
            const double along = 0.5 + power * static_cast<double>(n);
            setting.push_back(axis.at(along - std::floor(along)));
        }
        settings.push_back(std::move(setting));
    }
    return settings;
}

const char* stage_of(Effort effort) {
    return effort == Effort::glance ? "glance" : effort == Effort::look ? "look" : "all";
}

class Search {
 public:
    Search(const std::vector<TuneAxis>& axes, const TuneGoal& goal, const TuneJudge& judge,
           const std::function<bool()>& stop)
        : axes_(axes), goal_(goal), judge_(judge), stop_(stop) {}

    TuneOutcome outcome() {
        const TuneSetting standard = standard_setting(axes_);
        keep_best({standard}, judged({standard}, Effort::all, "defaults"));
        std::vector<TuneSetting> rung = spread_settings(axes_, kSettings - 1);
        rung.insert(rung.begin(), standard);
        // The defaults stand in the first rung, so that its best is better than they are by the same effort.
        std::pair<TuneSetting, std::optional<Judged>> so_far = {standard, std::nullopt};
        for (const Effort effort : {Effort::glance, Effort::look, Effort::all}) {
            const std::vector<std::optional<Judged>> found = judged(rung, effort, stage_of(effort));
            if (outcome_.interrupted) break;
            const std::vector<std::size_t> order = best_first(rung, found);
            if (order.empty()) break;
            so_far = {rung[order[0]], found[order[0]]};
            std::vector<TuneSetting> next;
            for (const std::size_t i : order) {
                if (next.size() < (rung.size() + kKept - 1) / kKept) next.push_back(rung[i]);
            }
            rung = std::move(next);
        }
        keep_best({so_far.first}, {so_far.second});
        if (!outcome_.best.empty()) {
            descend();
            return_to_defaults();
        }
        return std::move(outcome_);
    }

 private:
    std::vector<std::optional<Judged>> judged(const std::vector<TuneSetting>& settings, Effort effort,
                                              const char* stage) {
        outcome_.interrupted = outcome_.interrupted || (!outcome_.tried.empty() && stop_());
        if (outcome_.interrupted || settings.empty())
            return std::vector<std::optional<Judged>>(settings.size());
        const std::vector<std::optional<Judged>> found = judge_(settings, effort);
        for (std::size_t i = 0; i < settings.size(); ++i)
            outcome_.tried.push_back({settings[i], found[i], stage});
        return found;
    }

    // True where one of them is better than the best so far.
    bool keep_best(const std::vector<TuneSetting>& settings,
                   const std::vector<std::optional<Judged>>& found) {
        bool improved = false;
        for (std::size_t i = 0; i < settings.size(); ++i) {
            if (!found[i] || (!outcome_.best.empty() && !goal_.better(*found[i], outcome_.judged))) continue;
            outcome_.best = settings[i];
            outcome_.judged = *found[i];
            improved = true;
        }
        return improved;
    }

    // Indices of those that were judged.
    std::vector<std::size_t> best_first(const std::vector<TuneSetting>& rung,
                                        const std::vector<std::optional<Judged>>& found) const {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < rung.size(); ++i) {
            if (found[i]) order.push_back(i);
        }
        std::ranges::stable_sort(
            order, [&](std::size_t a, std::size_t b) { return goal_.better(*found[a], *found[b]); });
        return order;
    }

    // The best setting with one axis a step up or down; where the step leads to the same value, to the next one.
    std::vector<TuneSetting> neighbours(std::size_t axis, double step) const {
        std::vector<TuneSetting> settings;
        const TuneAxis& along = axes_[axis];
        const double share = along.share_of(outcome_.best[axis]);
        const double next =
            along.values.empty() ? step : std::max(step, 1.0 / static_cast<double>(along.values.size()));
        for (const double way : {-next, next}) {
            TuneSetting setting = outcome_.best;
            setting[axis] = along.at(share + way);
            if (setting[axis] != outcome_.best[axis]) settings.push_back(std::move(setting));
        }
        return settings;
    }

    void descend() {
        double step = kFirstStep;
        for (int round = 0; round < kMostRounds && step >= kSmallestStep && !outcome_.interrupted; ++round) {
            bool improved = false;
            for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
                const std::vector<TuneSetting> beside = neighbours(axis, step);
                if (keep_best(beside, judged(beside, Effort::all, "step"))) improved = true;
            }
            if (!improved) step /= 2;
        }
    }

    void return_to_defaults() {
        for (std::size_t axis = 0; axis < axes_.size() && !outcome_.interrupted; ++axis) {
            TuneSetting setting = outcome_.best;
            setting[axis] = axes_[axis].standard;
            if (setting == outcome_.best) continue;
            const std::optional<Judged> found = judged({setting}, Effort::all, "back")[0];
            if (!found || !goal_.as_good(*found, outcome_.judged, kNoDifference)) continue;
            outcome_.best = std::move(setting);
            outcome_.judged = *found;
        }
    }

    const std::vector<TuneAxis>& axes_;
    const TuneGoal& goal_;
    const TuneJudge& judge_;
    const std::function<bool()>& stop_;
    TuneOutcome outcome_;
};

}  // namespace

bool TuneGoal::met(const Judged& judged) const { return ms ? judged.ms <= *ms : judged.error <= *error; }

bool TuneGoal::as_good(const Judged& a, const Judged& b, double share) const {
    if (met(a) != met(b)) return met(a);
    const bool by_error = met(a) == ms.has_value();
    return by_error ? a.error <= b.error * (1 + share) : a.ms <= b.ms * (1 + share);
}

bool TuneGoal::better(const Judged& a, const Judged& b) const {
    if (met(a) != met(b)) return met(a);
    // Within the goal the other number counts, beyond it the one that it sets. Of equal times the smaller error is better:
    // from there the way to fewer samples is open.
    const bool by_error = met(a) == ms.has_value();
    if (by_error) return a.error < b.error;
    return std::pair(time_step(a.ms), a.error) < std::pair(time_step(b.ms), b.error);
}

std::vector<PlannedJudgements> planned_judgements(const std::vector<TuneAxis>& axes) {
    const auto axis_count = static_cast<long long>(axes.size());
    const auto all = static_cast<long long>(1 + kSettings / kKept / kKept);
    return {{Effort::glance, static_cast<long long>(kSettings)},
            {Effort::look, static_cast<long long>(kSettings / kKept)},
            {Effort::all, all + axis_count * (2 * kMostRounds + 1)}};
}

TuneOutcome tune_search(const std::vector<TuneAxis>& axes, const TuneGoal& goal, const TuneJudge& judge,
                        const std::function<bool()>& stop) {
    return Search(axes, goal, judge, stop).outcome();
}

}  // namespace crevice
