// The page of `crevice bench --scale`: its curves and tables, in one file that opens offline.
#pragma once

#include <string>
#include <vector>

#include "chapters/bench/scale.h"

namespace crevice {

std::string scale_page(const BenchReport& report, const std::vector<ScaleStudy>& studies);

}  // namespace crevice
