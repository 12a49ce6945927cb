#include "chapters/study/turns.h"

#include <numeric>
#include <utility>

#include "rasterizer/base/hash.h"

namespace crevice {

namespace {

bool is_slow(const Stopwatch& watch, const TurnPlan& plan) {
    for (const PassSamples& samples : watch.samples()) {
        if (samples.wall_ms.front() > plan.slow_ms) return true;
    }
    return false;
}

}  // namespace

std::vector<std::size_t> turn_order(std::size_t count, int round, std::uint32_t seed) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) {
        const std::uint32_t hash =
            hash_of(seed, static_cast<std::uint32_t>(round), static_cast<std::uint32_t>(i));
        std::swap(order[i - 1], order[hash % i]);
    }
    return order;
}

std::vector<Stopwatch> take_turns(std::span<const TimedWork> works, const TurnPlan& plan,
                                  const std::function<void()>& on_round) {
    std::vector<Stopwatch> watches(works.size());
    for (int round = -1; round < plan.rounds; ++round) {
        for (const std::size_t i : turn_order(works.size(), round, plan.seed)) {
            if (round < 0) {
                Stopwatch warm_up;
                works[i](warm_up);
            } else if (round < plan.slow_rounds || !is_slow(watches[i], plan)) {
                works[i](watches[i]);
            }
        }
        if (on_round) on_round();
    }
    return watches;
}

}  // namespace crevice
