// `crevice compare A B`: how two images, or two directories of images, differ.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

namespace crevice {

struct CompareOptions {
    std::filesystem::path a, b;                 // two .npy or .png files, or two directories
    std::optional<std::filesystem::path> html;  // where to write the page, if at all
    std::filesystem::path out = ".";            // the directory for error images
};

// Prints RMSE, MAE, signed bias (A - B), max, p99, SSIM, differing pixels and NaN/Inf of each pair. Of two
// directories every NAME.npy is compared; one that is on one side only, or of another shape there, counts as
// differing. For a pair that differs, the signed difference A - B goes to OUT as error.npy and error.png
// (NAME_error.* of directories). PNG values count as k/255, or as k/65535 where there are 16 bits,
// as the file encodes them; alpha, where any has it, is a pair of its own (error_alpha.*), and sRGB codes against
// linear values are a warning on stderr. Returns 0 when all
// pairs have the same bits and no NaN, else 1. Throws InputError when a file cannot be read, the two are of
// different kinds or shapes, or the directories hold no .npy at all; OutputError when writing fails.
int compare_files(const CompareOptions& options, std::ostream& report);

}  // namespace crevice
