// Sweeps and merges in scratch directories, and times that no clock has measured.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "chapters/sweep/merge_sweep.h"
#include "chapters/sweep/run_sweep.h"
#include "chapters/sweep/sweep_directory.h"
#include "chapters/sweep/sweep_words.h"
#include "chapters/terminal/program_version.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/write_file.h"
#include "tests/tools/scratch_directory.h"

namespace crevice {

inline std::string file_text(const std::filesystem::path& path) { return read_file(path, 1 << 28); }

// The path of a file with the plan.
inline std::string plan_file(const ScratchDirectory& scratch, const std::string& plan) {
    write_file_atomically(scratch / "plan.json", plan);
    return (scratch / "plan.json").string();
}

// What the command says at its end.
inline std::string swept(const std::string& plan, const std::filesystem::path& out, Shard shard = {},
                         bool list = false) {
    std::ostringstream said;
    SweepOptions options;
    options.plan = plan;
    options.out = out;
    options.shard = shard;
    options.list = list;
    options.run.threads = 1;
    CHECK(run_sweep(options, said) == 0);
    return said.str();
}

inline int merge_code(const std::vector<std::filesystem::path>& directories,
                      const std::filesystem::path& out) {
    std::ostringstream told;
    return write_merged(merged(directories), out, told);
}

// A finished time job of a plan with times, with made-up times: no test waits for a clock, nor depends on one.
inline FinishedJob made_up_times(const SweepJob& job) {
    FinishedJob done{
        job.id, version_text(program_version()), {}, SweepMachine{"a CPU", "avx2", "GCC", "0.1.0", 2, 8}, {}};
    for (const SweepSetting& setting : job.settings) {
        const double ms = 1.5 * static_cast<double>(1 + done.times.size());
        SweepTimeResult time;
        time.id = job.id;
        time.view = job.view;
        time.setting = setting;
        time.threads = job.threads;
        time.rounds = job.rounds;
        time.passes = {
            {"ao and blur", {ms, ms - 0.1, ms + 0.1, 0.96}, {ms, ms - 0.1, ms + 0.1, 0.96}, 0.05, 0}};
        time.hash = "0123456789abcdef";
        done.times.push_back(time);
    }
    return done;
}

}  // namespace crevice
