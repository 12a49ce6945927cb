// The report of `crevice bench --error` as one HTML page that opens offline.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/table.h"
#include "chapters/study/error_study.h"
#include "chapters/study/methods_study.h"

namespace crevice {

// Facts; of each method the error over time with the Pareto front, bias over time, its error taken apart as stacked bars
// and as signed pictures, and the tables.
std::string error_page(const BenchReport& report, const MethodsStudy& all,
                       const std::vector<ErrorStudy>& studies);

}  // namespace crevice
