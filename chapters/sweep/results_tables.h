// The results of a sweep as a table and as Markdown.
#pragma once

#include <string>

#include "chapters/notebook/table.h"
#include "chapters/sweep/sweep_results.h"

namespace crevice {

// One row a setting, view and number of threads, in the plan's order; without times one a setting and view. "soft_rmse" is the
// root of the mean square over the seeds, "soft_rmse_lowest" and "_highest" those of single seeds, all others means over the
// seeds; "hard_..." likewise. Seeds whose image is not finite count as "failed_seeds" alone. Times in ms.
Table results_table(const SweepResults& results);

// Plan, version, machine, what is missing, and the table's main columns.
std::string results_markdown(const SweepResults& results);

}  // namespace crevice
