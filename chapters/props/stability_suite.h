// The cases of `crevice stability --quick` with some of the methods: for chapter 22.
#pragma once

#include <string>
#include <vector>

#include "chapters/stability/stability.h"

namespace crevice {

struct StabilitySuite {
    std::vector<StiffCase> cases;
    std::vector<StabilityCell> cells;  // case by case; they point into `cases`

    int count(StabilityVerdict verdict) const;
};
StabilitySuite stability_suite(const std::vector<std::string>& methods);

// A row a case, a column a method; `cells` row by row.
std::string heat_map(const std::vector<StabilityCell>& cells, const std::vector<std::string>& methods);

}  // namespace crevice
