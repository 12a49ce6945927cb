// `crevice compare`
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/compare/compare.h"
#include "chapters/terminal/parse.h"

namespace crevice {

namespace {

// As they were typed.
struct CompareWords {
    std::string a, b;
    std::optional<std::string> max_abs, rmse, flip, ssim, max_pixels, limits, html, junit, out;
    bool json = false, bless = false;
};

std::optional<double> limit(const char* flag, const std::optional<std::string>& word, double lowest,
                            double highest) {
    if (!word) return std::nullopt;
    const double value = parse_number(flag, *word);
    if (value >= lowest && value <= highest) return value;
    throw UsageError(std::string(flag) + ": out of range (" + *word + "); give a number from " +
                     std::to_string(static_cast<int>(lowest)) + (highest <= 1 ? " to 1" : " on"));
}

CompareOptions options_of(const CompareWords& words) {
    constexpr double kLargest = 1e300;
    CompareLimits limits{limit("--max-abs", words.max_abs, 0, kLargest),
                         limit("--rmse", words.rmse, 0, kLargest),
                         limit("--flip", words.flip, 0, 1),
                         limit("--ssim", words.ssim, -1, 1),
                         {}};
    if (words.max_pixels) limits.max_pixels = parse_whole("--max-pixels", *words.max_pixels, 0, 1LL << 40);
    return {words.a,     words.b,   limits,     words.limits, words.html,
            words.junit, words.out, words.json, words.bless};
}

}  // namespace

Command add_compare_command(CommandLine& program) {
    const auto words = std::make_shared<CompareWords>();
    CommandLine command = program.subcommand("compare",
                                             "Compare two images (.npy .pfm .png .tif), EXRs layer by layer, "
                                             "or two directories, exactly or within limits");
    command.required("A", words->a, "an image, an .exr of several layers, or a directory");
    command.required("B", words->b, "another; the goldens, where there are any");
    command.option("--max-abs", words->max_abs, "pass where no value differs by more");
    command.option("--rmse", words->rmse, "pass where the root of the mean squared difference is no more");
    command.option("--flip", words->flip, "pass where the mean FLIP of two pictures, [0, 1], is no more");
    command.option("--ssim", words->ssim, "pass where SSIM, [-1, 1], is no less");
    command.option("--max-pixels", words->max_pixels, "pass where no more pixels differ in any bit");
    command.option("--limits", words->limits,
                   "a file of limits a buffer; without it limits.json beside B's images, where there is one");
    command.option("--html", words->html,
                   "write a page with both, their difference and the first pixels that differ");
    command.option("--junit", words->junit, "write the report as JUnit's XML");
    command.flag("--json", words->json, "report in JSON");
    command.option("--out", words->out, "write signed error images into this directory");
    command.flag("--bless", words->bless, "copy what failed from A over B");
    return {command, [words] { return compare_files(options_of(*words), std::cout); }};
}

}  // namespace crevice
