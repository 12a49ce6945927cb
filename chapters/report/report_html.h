// A sweep's report as one page that opens offline. Without its script everything is there; with it, points tell what they are,
// plots zoom, and scenes, methods and threads can be chosen.
#pragma once

#include <span>
#include <string>

#include "chapters/report/report_sections.h"

namespace crevice {

// Pictures of points are read from beside the page, where somebody asks for one.
std::string report_html(const std::string& title, std::span<const ReportSection> sections);

}  // namespace crevice
