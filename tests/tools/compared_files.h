// `crevice compare` as tests call it.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>

#include "chapters/compare/compare.h"
#include "tests/tools/bytes_in.h"

namespace crevice {

struct ComparedOutcome {
    int code = -1;
    std::string report;
};

inline ComparedOutcome compare(const CompareOptions& options) {
    std::ostringstream report;
    const int code = compare_files(options, report);
    return {code, report.str()};
}

}  // namespace crevice
