// What a sweep found out: the error of every setting on every view, and what it costs. `crevice merge` puts these together
// from the files of finished jobs, and the report is made from nothing else.
// Errors: deterministic, so they are the same on every machine, and may come from many
// Times:  wall and processor time in ms; those of one machine only are ever compared
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "chapters/study/statistics.h"
#include "rasterizer/base/image.h"

namespace crevice {

// What is looked at, and at how many pixels.
struct SweepView {
    std::string scene;   // SCENE on the command line
    std::string camera;  // its camera flags as words, "--eye 0,1,5 --fov-y 60"; empty: the scene's own camera
    Size size{1280, 720};
    long long triangles = 0;

    bool operator==(const SweepView&) const = default;
};

// How a method runs: what the plan sets, lengths in scene units, in the order of the method's parameters,
// without the seed; all else as the method's defaults.
struct SweepSetting {
    std::string method;
    std::vector<std::pair<std::string, std::string>> parameters;  // {"samples", "8"}, {"ao_scale", "1"}

    bool operator==(const SweepSetting&) const = default;
};

// Of one AO image against one reference, over the pixels that show a surface (ssao/judge/reference_error.h).
struct SweepError {
    double rmse = 0;        // debiased; 0 where it is below the reference's noise
    double rmse_error = 0;  // its standard error, of pixels and reference
    double bias = 0;        // mean (image - reference)
    double mae = 0, p99 = 0;
    double flip = 0, ssim = 0;
    double reference_error = 0;  // root mean square of the reference's own standard error
    // The square of `rmse` before it was kept from going below 0, and its standard error: to be averaged over seeds.
    double mse = 0, mse_error = 0;
};

// A step of truth -> screen -> limit -> image, as ErrorPart has it.
struct SweepErrorPart {
    // "depth buffer", "definition", "half size", "sampling", "rounding", "float16", "blur, bias", "blur, noise removed"
    std::string step;
    double bias = 0, rmse = 0, share = 0;
};

// One finished error job: a setting and a seed on a view.
struct SweepErrorResult {
    std::string id;  // of the job: the hash of all that it is made from
    SweepView view;
    SweepSetting setting;
    std::uint32_t seed = 0;
    long long nan_or_inf = 0;           // pixels left out of the errors; above 0 the job has failed
    SweepError soft, hard;              // against ray-cast truth with the method's own fade, and without any
    std::vector<SweepErrorPart> parts;  // against soft truth; of the first seed, where the plan asks for them
    std::string hash;                   // of the AO image, as `crevice render` prints it
    std::string picture;  // PNG of the AO image, at most 320 pixels wide, relative to the results
    std::string command;  // that makes the same image, whole
    // Of the method's limit against soft truth, debiased, so that it may be below 0: what ever more samples would leave. With
    // the parts.
    std::optional<double> limit_mse;
};

// The sum of a method's passes, by whose times settings are compared.
inline constexpr const char* kWholePass = "ao and blur";

struct SweepPassTime {
    std::string pass;          // "ao", its inputs included; "blur", where there is one; kWholePass
    MedianInterval wall, cpu;  // ms, over the rounds after the warm-up
    double wall_mad = 0;       // median absolute deviation
    double instructions = 0;   // a frame; 0 where they were not counted
};

// What times were measured on and by.
struct SweepMachine {
    std::string cpu, isa, compiler, version;  // `version` with the commit
    int cores = 0, lanes = 0;

    bool operator==(const SweepMachine&) const = default;
};

// One setting of a finished timing job. A timing job times all settings of a view in turns, in random order, and each
// method's first setting twice, as if it were two: A/A, the noise floor of all ratios of that view.
struct SweepTimeResult {
    std::string id;  // of the timing job
    SweepView view;
    SweepSetting setting;
    int threads = 1, rounds = 0;
    std::vector<SweepPassTime> passes;
    // A/A: ratio of kWholePass, one of the setting's twins over the other.
    std::optional<MedianInterval> same_again;
    std::string hash;  // of the AO image, taken from inside the timed loop
    std::string command;
};

struct SweepResults {
    std::string plan;  // its name
    std::string plan_text;
    std::vector<SweepErrorResult> errors;  // in the plan's order
    std::vector<SweepTimeResult> times;    // in the plan's order
    std::optional<SweepMachine> machine;   // none where nothing was timed
    std::vector<std::string> missing;      // what the plan asks for and no job has done, in words
    std::string version;                   // of the program that did the jobs, with its commit
};

}  // namespace crevice
