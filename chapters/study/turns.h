// Timing in turns: what is compared shares the machine's moods, and none always follows the same other.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "chapters/terminal/stopwatch.h"

namespace crevice {

// Does its work once and times its passes with the watch; what it does beside them is not timed.
using TimedWork = std::function<void(Stopwatch& watch)>;

struct TurnPlan {
    int rounds = 0;          // that count; one more is thrown away before them
    std::uint32_t seed = 0;  // of the orders
    // Work of which a pass took more than slow_ms in the first counted round has so many.
    int slow_rounds = std::numeric_limits<int>::max();
    double slow_ms = std::numeric_limits<double>::infinity();
};

// In which order `count` works take their turns in a round: a shuffle of 0 ... count - 1, another one each round.
std::vector<std::size_t> turn_order(std::size_t count, int round, std::uint32_t seed);

// The watches of all works. `on_round` is called after each round, the first one included.
std::vector<Stopwatch> take_turns(std::span<const TimedWork> works, const TurnPlan& plan,
                                  const std::function<void()>& on_round = {});

}  // namespace crevice
