// What `crevice merge` writes of what it has put together.
#include <algorithm>
#include <iostream>
#include <ostream>

#include "chapters/sweep/merge_sweep.h"
#include "chapters/sweep/results_tables.h"
#include "chapters/sweep/sweep_directory.h"
#include "chapters/terminal/output_directory.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace fs = std::filesystem;

namespace {

// A plan may have thousands of jobs.
void tell_missing(const std::vector<std::string>& missing) {
    constexpr std::size_t kTold = 10;
    for (std::size_t i = 0; i < std::min(missing.size(), kTold); ++i)
        std::cerr << "missing: " << missing[i] << "\n";
    if (missing.size() > kTold)
        std::cerr << missing.size() - kTold << " more are missing, " << missing.size()
                  << " in all; results.json lists them\n";
}

void write_pictures(const Merged& merged, const fs::path& out) {
    for (std::size_t i = 0; i < merged.pictures.size(); ++i) {
        std::error_code ignored;
        const fs::path to = out / merged.results.errors[i].picture;
        if (merged.pictures[i].empty() || fs::equivalent(merged.pictures[i], to, ignored)) continue;
        write_file_atomically(to, read_file(merged.pictures[i], kLargestSweepFile));
    }
}

}  // namespace

int write_merged(const Merged& merged, const fs::path& out, std::ostream& told) {
    try_output_directory(out / "jobs");
    write_pictures(merged, out);
    const auto write = [&](const char* name, const std::string& text) {
        write_file_atomically(out / name, text);
        told << (out / name).string() << "\n";
    };
    for (const auto* lines : {&merged.damaged, &merged.faults}) {
        for (const std::string& line : *lines) std::cerr << line << "\n";
    }
    tell_missing(merged.results.missing);
    if (merged.not_of_plan > 0)
        told << merged.not_of_plan << " finished jobs are not of this plan and were left out\n";
    write("results.csv", csv_text(results_table(merged.results)));
    write("results.md", results_markdown(merged.results));
    write("results.json", results_json(merged.results));
    if (!merged.damaged.empty()) return static_cast<int>(ExitCode::input);
    const bool whole = merged.faults.empty() && merged.results.missing.empty();
    return static_cast<int>(whole ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace crevice
