#include "chapters/study/candidates.h"

#include <algorithm>
#include <cmath>

#include "chapters/study/turns.h"

namespace crevice {

void time_in_turns(std::vector<Candidate>& all, int rounds, int slow_rounds, const StudyProgress& progress) {
    std::vector<TimedWork> works;
    for (const Candidate& candidate : all) {
        works.emplace_back([&candidate](Stopwatch& watch) { watch.time("timed", candidate.timed); });
    }
    long long done = 0;
    const std::vector<Stopwatch> watches =
        take_turns(works, {rounds, kFirstStudySeed, slow_rounds, kSlow_ms}, [&] {
            if (progress) progress("timing", ++done, rounds + 1);
        });
    for (std::size_t i = 0; i < all.size(); ++i) all[i].point.time = watches[i].samples().front().summary();
}

ErrorSpread spread_of(std::span<const MeanError> errors) {
    ErrorSpread spread;
    double square = 0, squared_error = 0;
    spread.lowest = errors.front().squared.root();
    for (const MeanError& e : errors) {
        square += e.squared.mean / static_cast<double>(errors.size());
        squared_error += e.squared.error / static_cast<double>(errors.size());
        spread.bias += e.bias / static_cast<double>(errors.size());
        spread.lowest = std::min(spread.lowest, e.squared.root());
        spread.highest = std::max(spread.highest, e.squared.root());
    }
    spread.rmse = std::sqrt(std::max(square, 0.0));
    if (spread.rmse > 0) spread.error = squared_error / (2 * spread.rmse);
    return spread;
}

}  // namespace crevice
