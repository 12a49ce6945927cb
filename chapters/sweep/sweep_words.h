// Jobs, settings and views in words, as lists of jobs, messages and commands name them; and the frame that they stand for.
#pragma once

#include <string>
#include <vector>

#include "chapters/sweep/sweep_jobs.h"

namespace crevice {

// "columns 640x360, gtao samples=4 ao_scale=1, seed 1000" or "columns 640x360, times of 12 settings on 2 threads"
std::string words_of(const SweepJob& job);
std::string error_job_words(const SweepView& view, const SweepSetting& setting, std::uint32_t seed);
std::string time_job_words(const SweepView& view, std::size_t settings, int threads);
std::string words_of(const SweepSetting& setting);
std::string words_of(const SweepView& view);

// The settings in the scene's units. Throws UsageError where they are out of range.
FrameSettings frame_settings(const SweepSetting& setting, std::uint32_t seed, float length_unit);

// What `crevice` is called with to make the same image, as ao_blurred: "render", SCENE and flags.
std::vector<std::string> render_words(const SweepView& view, const SweepSetting& setting, std::uint32_t seed);
// The same as a line for a shell; threads 0: as many as there are.
std::string command_of(const SweepView& view, const SweepSetting& setting, std::uint32_t seed, int threads);

}  // namespace crevice
