// `crevice merge DIR...`: one set of results from the directories that shards of a sweep have written.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "chapters/sweep/sweep_results.h"

namespace crevice {

struct Merged {
    SweepResults results;
    // Files and directories that were left out: "FILE:LINE: what is wrong (value); what to do".
    std::vector<std::string> damaged;
    std::vector<std::string> faults;              // what is wrong with the results
    std::size_t not_of_plan = 0;                  // finished jobs that the plan does not ask for
    std::vector<std::filesystem::path> pictures;  // of `errors`, in their order; empty: there is none
};

// Throws InputError naming both where the directories are of different plans, scenes or versions of the program, or their
// times of different machines; and where no directory holds a sweep.
Merged merged(const std::vector<std::filesystem::path>& directories);

// Writes OUT/results.json, results.csv, results.md and jobs/ID.png. Returns 0; 1 where something is missing or wrong, which
// stderr names; 3 where files were damaged. Throws OutputError.
int write_merged(const Merged& merged, const std::filesystem::path& out, std::ostream& told);

}  // namespace crevice
