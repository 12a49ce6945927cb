// How a sweep's report begins.
#pragma once

#include <string>

#include "chapters/report/report_sections.h"

namespace crevice {

// "crevice sweep quick && crevice merge out/sweep_quick": what makes the results and the report. A plan that is not built in is
// called plan.json, as it stands beside the jobs; the report holds it, too.
std::string sweep_command(const SweepResults& results);

// What is missing or broken first; what the results were made with; how to read them.
ReportSection summary_section(const SweepResults& results);

}  // namespace crevice
