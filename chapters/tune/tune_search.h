// The search of `crevice tune`: which setting has the least error within a time, or the least time within an error.
// Three parts, each plain enough to be followed by hand:
//   1. Successive halving. Many settings, spread evenly over all axes, are judged by little; the best quarter of them is
//      judged again by more, and so on. Source: Jamieson and Talwalkar 2016, "Non-stochastic best arm identification and
//      hyperparameter optimization"; the spread is Roberts' R sequence, "The unreasonable effectiveness of quasirandom
//      sequences" (2018)
//   2. Coordinate descent from the best of these: one axis at a time a step up, a step down; half the step when none helps.
//   3. Back to the defaults, one axis at a time, where that makes no difference worth a parameter.
// The same measurements give the same answer; the defaults are always among the settings.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "chapters/tune/tune_axes.h"

namespace crevice {

// What is known of a setting.
struct Judged {
    double error = 0;  // RMSE, >= 0
    double ms = 0;     // > 0
};

// One of the two is set.
struct TuneGoal {
    std::optional<double> ms;     // the least error of settings that take no longer
    std::optional<double> error;  // the least time of settings that are no worse

    bool met(const Judged& judged) const;
    // Settings that meet the goal come before those that do not; of these the nearer to it is better.
    bool better(const Judged& a, const Judged& b) const;
    // Whether `a` is better, or worse by no more than this share.
    bool as_good(const Judged& a, const Judged& b, double share) const;
};

// How much is spent on one judgement.
enum class Effort { glance, look, all };

// Judges settings against the same things, so that they can be compared with each other. A setting may come back empty: it
// was plainly too slow to be waited for, or is none that the method takes.
using TuneJudge =
    std::function<std::vector<std::optional<Judged>>(std::span<const TuneSetting> settings, Effort effort)>;

struct TuneTrial {
    TuneSetting setting;
    std::optional<Judged> judged;
    const char* stage = "";  // "defaults", "glance", "look", "all", "step", "back"
};

struct TuneOutcome {
    std::vector<TuneTrial> tried;  // every judgement, in its order
    TuneSetting best;  // empty: nothing was judged
    Judged judged;
    bool interrupted = false;
};

// How many settings are judged at most with each effort, for a progress bar.
struct PlannedJudgements {
    Effort effort;
    long long settings;
};
std::vector<PlannedJudgements> planned_judgements(const std::vector<TuneAxis>& axes);

// `stop` is asked before each judgement: once it says yes, the best so far is the answer, judged by whatever it was judged
// by until then.
TuneOutcome tune_search(const std::vector<TuneAxis>& axes, const TuneGoal& goal, const TuneJudge& judge,
                        const std::function<bool()>& stop);

}  // namespace crevice
