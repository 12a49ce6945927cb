// The page of `crevice stability`: a heat map of methods and cases, each cell a link to its picture and command.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/table.h"
#include "chapters/stability/rounding.h"
#include "chapters/stability/stability.h"

namespace crevice {

// What draws a cell again.
std::string command_of(const StabilityCell& cell);

std::string stability_page(const BenchReport& report, const std::vector<StabilityCell>& cells,
                           const std::vector<CaseRounding>& rounding);

}  // namespace crevice
