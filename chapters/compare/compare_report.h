// What `crevice compare` found, for people and for programs.
#pragma once

#include <iosfwd>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "chapters/compare/compare_limits.h"
#include "chapters/compare/difference_page.h"

namespace crevice {

struct ComparedPair {
    const DifferenceEntry* entry = nullptr;
    CompareLimits limits;
    std::optional<ImageError> error;                         // none: there is no pair of one shape
    double flip = std::numeric_limits<double>::quiet_NaN();  // mean; NaN: not asked for
    std::vector<std::string> failures;                       // sentences; none: it passes
    bool judged = true;                                      // false: a file or its values allow no verdict

    bool passed() const { return failures.empty(); }
    // "identical", "differs", or what the pair is where there are limits: "within its limits", "beyond its limits"
    std::string verdict() const;
};

// All numbers of a pair, each on a line of its own.
void print_pair(std::ostream& out, const ComparedPair& pair);

// {"a", "b", "failed": count, "pairs": [{"name", "passed", "failures": [...], "shape": [H, W, components], "rmse", ...}]}
std::string json_report(const std::string& a, const std::string& b, std::span<const ComparedPair> pairs);
// One test case a pair, as Jenkins, GitLab and GitHub's actions read it.
std::string junit_report(std::span<const ComparedPair> pairs);

}  // namespace crevice
