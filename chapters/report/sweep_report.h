// The report of a sweep, as `crevice merge` writes it beside the results.
#pragma once

#include <filesystem>

#include "chapters/sweep/sweep_results.h"

namespace crevice {

// DIR/report.html, one page that opens offline in the frame of the book; DIR/report.md; and each plot as a file of its own,
// DIR/plots/NAME.svg. Made of nothing but the results, so that equal results give the same bytes. Throws OutputError.
void write_sweep_report(const SweepResults& results, const std::filesystem::path& dir);

}  // namespace crevice
