// `crevice compare` as tests call it.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "chapters/compare/compare.h"

namespace crevice {

inline std::string bytes_in(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

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
