// Pictures that a study judges and times.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "chapters/study/error_study.h"

namespace crevice {

// Seeds of the images that are judged: none of them is a reference's.
inline constexpr std::uint32_t kFirstStudySeed = 1000;

// A point and how to make its picture, and how to do only what is timed.
struct Candidate {
    StudyPoint point;
    bool of_method = false;
    std::function<Image<float>(std::uint32_t seed)> picture;
    std::function<void()> timed;
};

// All candidates in turns (turns.h); each point's time is set. Those that take more than kSlow_ms have `slow_rounds` rounds.
void time_in_turns(std::vector<Candidate>& all, int rounds, int slow_rounds, const StudyProgress& progress);

// Roots of each image's mean square; the mean square of all for the middle.
ErrorSpread spread_of(std::span<const MeanError> errors);

}  // namespace crevice
