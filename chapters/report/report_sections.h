// What a sweep's report holds, in its order, for the page and for Markdown alike.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/cells.h"
#include "chapters/sweep/sweep_results.h"

namespace crevice {

struct ReportBlock {
    std::string id = "";       // what the page's script finds it by; may be empty
    std::string heading = "";  // plain text; may be empty
    std::string prose = "";    // Markdown; may be empty
    std::vector<Output> outputs = {};
    // Where the outputs show one thing in several ways, their names; one is shown.
    std::vector<std::string> choices = {};
    bool folded = false;  // long, and behind its heading
    int threads = 0;      // 0: for any number of them
};

struct ReportSection {
    std::string id, heading;  // plain text
    std::string scene = "";   // that it is about; empty: all
    std::vector<ReportBlock> blocks = {};
};

// What is missing first; then a section a view, what it costs, and the plan.
std::vector<ReportSection> report_sections(const SweepResults& results);

}  // namespace crevice
