// Time jobs: all settings of a view take turns in random order, each method's first setting twice, and every image is held
// against the error job's.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "chapters/study/turns.h"
#include "chapters/sweep/sweep_jobs.h"

namespace crevice {

SweepPassTime pass_time(const PassSamples& samples);

// A/A: the times of a pass over those of the same pass of a setting that is entered twice, round by round.
MedianInterval same_again(const PassSamples& once, const PassSamples& again);

// One setting of a time job.
struct TimedSetting {
    SweepSetting setting;
    std::string expected_hash;                    // of the AO map; empty: that of the first round
    std::function<Image<float>(Stopwatch&)> map;  // times kWholePass and its passes; the map they made
};

// One result a setting, with its passes, its A/A where it is its method's first, and its hash; id, view, threads and command
// are left to the caller. Throws Error naming the setting and both hashes as soon as a map is not the one expected.
std::vector<SweepTimeResult> timed_in_turns(const std::vector<TimedSetting>& settings, int rounds,
                                            std::uint32_t seed, const std::function<void()>& on_round);

// Sets the instructions of each result's passes: those of one frame on one thread, which `program` renders under valgrind.
// Throws as counted_frame().
void count_instructions(std::vector<SweepTimeResult>& results, const SweepJob& job,
                        const std::filesystem::path& program);

// Does a time job. `hashes`: of the error jobs of the same view and seed that are finished, by json_line() of their
// settings. Throws as timed_in_turns().
std::vector<SweepTimeResult> timed(const SweepJob& job, const std::map<std::string, std::string>& hashes,
                                   const std::function<void()>& on_round);

}  // namespace crevice
