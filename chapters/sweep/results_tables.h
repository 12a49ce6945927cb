// The results of a sweep as a table and as Markdown.
#pragma once

#include <string>

#include "chapters/notebook/table.h"
#include "chapters/sweep/sweep_results.h"

namespace crevice {

// One row a setting, view and number of threads, in the plan's order; without times one a setting and view. Errors are roots
// of the mean square over the seeds, or their mean: "rmse_soft", "rmse_soft_lowest", ...; times in ms.
Table results_table(const SweepResults& results);

// Plan, version, machine, what is missing, and the table's main columns.
std::string results_markdown(const SweepResults& results);

}  // namespace crevice
