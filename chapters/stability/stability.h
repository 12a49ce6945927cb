// `crevice stability`: every method on every stiff case, what was measured against the answer that was stated.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "chapters/notebook/picture.h"
#include "chapters/stability/stiff_cases.h"

namespace crevice {

enum class StabilityVerdict {
    exact,   // the answer to the last bit; of Answer::in_range: in range
    within,  // within what is stated: kStatedBias
    warned,  // further off, and the frame says that precision was lost; or refused in one line
    wrong,   // further off in silence, not finite, or out of [0,1]
};
const char* word_of(StabilityVerdict verdict);

struct StabilityCell {
    const StiffCase* stiff = nullptr;
    const Method* method = nullptr;
    double measured = 0;  // how far the mean is below 1; of Answer::same: the largest difference of a texel
    double covered = 0;   // share of the picture that shows a surface
    std::string warning;  // the first that the frame gave, or the line that refused it; empty: none
    StabilityVerdict verdict = StabilityVerdict::exact;
    Picture ao;
};

// One method on one case.
StabilityCell stability_cell(const StiffCase& stiff, const Method& method, const Run& run);

struct StabilityOptions {
    bool quick = false;
    std::string only_case, only_method;  // empty: all
    Run run;
    std::filesystem::path out = "out";
};

// Writes OUT/stability.html, .csv and .json. Returns 0, or 1 when a cell is wrong. Throws UsageError, OutputError.
int stability(const StabilityOptions& options, std::ostream& out);

}  // namespace crevice
