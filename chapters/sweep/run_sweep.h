// `crevice sweep PLAN`: does the jobs of a plan that are not done yet.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

#include "chapters/sweep/shards.h"

namespace crevice {

struct SweepOptions {
    std::string plan;                          // a built-in one or a file
    std::optional<std::filesystem::path> out;  // none: out/sweep_NAME
    Shard shard;
    bool list = false;                           // name the jobs, do none
    bool instructions = false;                   // time jobs count instructions, too
    Run run;                                     // of the error jobs; timings have the plan's threads
    std::optional<std::filesystem::path> cache;  // of the references
    std::filesystem::path program;               // this one, whose instructions are counted
};

// Returns 0, or 1 where jobs failed, which are named on stderr; the others are done all the same. Throws UsageError and
// InputError for the plan and its scenes, OutputError as soon as a result cannot be written.
int run_sweep(const SweepOptions& options, std::ostream& out);

}  // namespace crevice
