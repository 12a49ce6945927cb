// `crevice compare A B`: how two images, or two directories of images, differ, and whether they may.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

#include "chapters/compare/compare_limits.h"

namespace crevice {

struct CompareOptions {
    std::filesystem::path a, b;  // files or directories of images (compared_files.h); b holds the goldens
    CompareLimits limits = {};   // of every pair that no file of limits names
    // None: kLimitsFile in the directory b, where there is one.
    std::optional<std::filesystem::path> limits_file = {};
    std::optional<std::filesystem::path> html = {};   // where to write the page, if at all
    std::optional<std::filesystem::path> junit = {};  // and the report in JUnit's form
    std::optional<std::filesystem::path> out = {};    // the directory for signed error images, which is made
    bool json = false;                                // report in JSON
    bool bless = false;                               // afterwards copy what failed from a over b, and pass
};

// Reports RMSE, MAE, signed bias (A - B), max, p99, SSIM, differing pixels and NaN/Inf of two files, and of those pairs of
// several that fail; what only one of these has, or of another shape there, fails. For a pair that
// differs, the signed difference A - B goes to OUT as error.npy and error.png (NAME_error.* of directories).
// Returns 0 when all pairs pass, 3 when one of several allows no verdict (the others are reported), else 1; with `bless` 0
// when all that failed was copied, or when b is not there yet and was made. Throws InputError as compared_entries() and
// limits_from_text() do; OutputError when writing fails.
int compare_files(const CompareOptions& options, std::ostream& report);

}  // namespace crevice
