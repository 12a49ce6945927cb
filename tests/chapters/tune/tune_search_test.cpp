// The search on made-up methods whose best settings are known, quiet and noisy, possible and impossible; and what it does
// when it is cut short.
#include "chapters/tune/tune_search.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

// error^2 = 0.5 / samples + (log2(radius))^2 + (bias - 0.3)^2: without an end to time the best are the most samples,
// radius 1 and bias 0.3. ms = 0.5 samples.
const std::vector<TuneAxis> kAxes = {
    {"samples", "-", 4, {1, 2, 4, 8, 16, 32}, 0, 0, false, false},
    {"radius", "scene", 2, {}, 0.25, 4, true, true},
    {"bias", "-", 0.8, {}, 0, 1, false, false},
};

Judged known(const TuneSetting& s) {
    const double octaves = std::log2(s[1]), off = s[2] - 0.3;
    return {std::sqrt(0.5 / s[0] + octaves * octaves + off * off), 0.5 * s[0]};
}

TuneJudge judge_by(const std::function<Judged(const TuneSetting&, Effort)>& one) {
    return [=](std::span<const TuneSetting> settings, Effort effort) {
        std::vector<std::optional<Judged>> judged;
        for (const TuneSetting& setting : settings) judged.push_back(one(setting, effort));
        return judged;
    };
}
const TuneJudge kKnown = judge_by([](const TuneSetting& s, Effort) { return known(s); });
const std::function<bool()> kNever = [] { return false; };

TuneGoal within_ms(double ms) { return {ms, {}}; }
TuneGoal within_error(double error) { return {{}, error}; }

}  // namespace

TEST_CASE("tune search: the least error within a time is the known one") {
    for (const auto& [ms, samples] : {std::pair(20.0, 32.0), {5.0, 8.0}, {0.6, 1.0}}) {
        CAPTURE(ms);
        const TuneOutcome outcome = tune_search(kAxes, within_ms(ms), kKnown, kNever);
        CHECK(outcome.best[0] == samples);
        CHECK(outcome.best[1] == doctest::Approx(1).epsilon(0.06));
        CHECK(outcome.best[2] == doctest::Approx(0.3).epsilon(0.15));
        CHECK(outcome.judged.ms <= ms);
        // No further from the optimum than a twentieth of what the defaults are.
        const double least = std::sqrt(0.5 / samples), standard = known(standard_setting(kAxes)).error;
        CHECK(outcome.judged.error - least < 0.05 * (standard - least));
        CHECK(!outcome.interrupted);
        long long most = 0;
        for (const PlannedJudgements& planned : planned_judgements(kAxes)) most += planned.settings;
        CHECK(static_cast<long long>(outcome.tried.size()) <= most);
    }
}

TEST_CASE("tune search: the least time within an error is the known one") {
    // 0.5 / samples <= 0.27^2 from 7 samples on, of which there are 8.
    const TuneOutcome outcome = tune_search(kAxes, within_error(0.27), kKnown, kNever);
    CHECK(outcome.best[0] == 8);
    CHECK(outcome.judged.error <= 0.27);
    CHECK(outcome.judged.ms == 4);
}

TEST_CASE("tune search: what cannot be met has the nearest") {
    const TuneOutcome too_fast = tune_search(kAxes, within_ms(0.1), kKnown, kNever);
    CHECK(!within_ms(0.1).met(too_fast.judged));
    CHECK(too_fast.judged.ms == 0.5);
    const TuneOutcome too_good = tune_search(kAxes, within_error(0.01), kKnown, kNever);
    CHECK(!within_error(0.01).met(too_good.judged));
    CHECK(too_good.best[0] == 32);
    CHECK(too_good.judged.error < 0.15);
}

TEST_CASE(
    "tune search: noise of two parts in a hundred does not lead it astray, and the same noise leads it "
    "nowhere else") {
    const auto noisy_outcome = [](std::uint32_t seed) {
        RandomSequence random(seed);
        // Times by a fifth, as on a busy machine.
        return tune_search(kAxes, within_ms(5), judge_by([&](const TuneSetting& s, Effort) {
                               const Judged j = known(s);
                               return Judged{j.error * (1 + random.between(-0.02, 0.02)),
                                             j.ms * (1 + random.between(0, 0.2))};
                           }),
                           kNever);
    };
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const TuneOutcome outcome = noisy_outcome(seed);
        CAPTURE(seed);
        CHECK(known(outcome.best).error < 0.32);  // the best of 8 samples is 0.25, the defaults have 1.16
        CHECK(known(outcome.best).ms <= 5);
        CHECK(noisy_outcome(seed).best == outcome.best);
    }
}

TEST_CASE(
    "tune search: what takes too long or is no setting is left aside, and the defaults stay where nothing is "
    "better") {
    const TuneJudge only_defaults = [](std::span<const TuneSetting> settings, Effort) {
        std::vector<std::optional<Judged>> judged;
        for (const TuneSetting& s : settings)
            judged.push_back(s == standard_setting(kAxes) ? std::optional<Judged>({0.1, 1}) : std::nullopt);
        return judged;
    };
    const TuneOutcome outcome = tune_search(kAxes, within_ms(2), only_defaults, kNever);
    CHECK(outcome.best == standard_setting(kAxes));
    const TuneOutcome flat = tune_search(kAxes, within_ms(2), judge_by([](const auto&, Effort) {
                                             return Judged{0.1, 1};
                                         }),
                                         kNever);
    CHECK(flat.best == standard_setting(kAxes));
}

TEST_CASE("tune search: where nothing can be judged there is no answer") {
    const TuneJudge nothing = [](std::span<const TuneSetting> settings, Effort) {
        return std::vector<std::optional<Judged>>(settings.size());
    };
    CHECK(tune_search(kAxes, within_ms(2), nothing, kNever).best.empty());
}

TEST_CASE("tune search: what makes no difference stays at its default") {
    std::vector<TuneAxis> axes = kAxes;
    axes.push_back({"idle", "-", 0.25, {}, 0, 1, false, false});
    // A trace of noise, which a search that only looks for less would follow.
    const TuneOutcome outcome = tune_search(axes, within_ms(20), judge_by([](const TuneSetting& s, Effort) {
                                                const Judged j = known(s);
                                                return Judged{j.error - 1e-6 * s[3], j.ms};
                                            }),
                                            kNever);
    CHECK(outcome.best[3] == 0.25);
    CHECK(outcome.best[0] == 32);
}

TEST_CASE("tune search: interrupted, it tells the best so far") {
    // After the defaults and so many rungs; what is then being judged comes to nothing.
    for (const int rungs : {1, 2}) {
        CAPTURE(rungs);
        int judgements = 0;
        const std::function<bool()> stop = [&] { return judgements > 1 + rungs; };
        const TuneJudge counted = [&](std::span<const TuneSetting> settings, Effort effort) {
            ++judgements;
            return stop() ? std::vector<std::optional<Judged>>(settings.size()) : kKnown(settings, effort);
        };
        const TuneOutcome outcome = tune_search(kAxes, within_ms(20), counted, stop);
        CHECK(outcome.interrupted);
        CHECK(judgements == 2 + rungs);
        double least = std::numeric_limits<double>::infinity();
        for (const TuneTrial& trial : outcome.tried) {
            if (trial.judged) least = std::min(least, trial.judged->error);
        }
        CHECK(outcome.judged.error == least);
        CHECK(least < known(standard_setting(kAxes)).error);
    }
}

TEST_CASE(
    "tune search: settings that meet the goal come first, then by the other number; beyond it by the goal's "
    "own") {
    const TuneGoal ms = within_ms(5);
    CHECK(ms.better({0.2, 4}, {0.1, 6}));
    CHECK(ms.better({0.1, 5}, {0.2, 1}));
    CHECK(ms.better({0.9, 6}, {0.1, 7}));
    const TuneGoal error = within_error(0.1);
    CHECK(error.better({0.1, 9}, {0.2, 1}));
    CHECK(error.better({0.1, 1}, {0.05, 2}));
    CHECK(error.better({0.2, 9}, {0.3, 1}));
    CHECK(!ms.better({0.1, 1}, {0.1, 1}));
}
