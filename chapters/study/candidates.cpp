#include "chapters/study/candidates.h"

#include <algorithm>
#include <cmath>

namespace crevice {

void time_in_turns(std::vector<Candidate>& all, int rounds, int slow_rounds, const StudyProgress& progress) {
    std::vector<PassSamples> samples(all.size());
    for (int round = -1; round < rounds; ++round) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            PassSamples& own = samples[i];
            const bool slow = !own.wall_ms.empty() && own.wall_ms.front() > kSlow_ms;
            if (slow && round >= slow_rounds) continue;
            const Clocks before = clocks();
            all[i].timed();
            const Clocks after = clocks();
            if (round < 0) continue;
            own.wall_ms.push_back(after.wall_ms - before.wall_ms);
            own.cpu_ms.push_back(after.cpu_ms - before.cpu_ms);
        }
        if (progress) progress("timing", round + 2, rounds + 1);
    }
    for (std::size_t i = 0; i < all.size(); ++i) all[i].point.time = samples[i].summary();
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
