// A sweep's report as GitHub-flavoured Markdown; plots are linked as the files beside it.
#pragma once

#include <span>
#include <string>

#include "chapters/report/report_sections.h"

namespace crevice {

std::string report_markdown(const std::string& title, std::span<const ReportSection> sections);

}  // namespace crevice
