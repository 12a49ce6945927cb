// `crevice compare`
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/compare.h"

namespace crevice {

namespace {

// As they were typed.
struct CompareWords {
    std::string a, b, out = ".";
    std::optional<std::string> html;
};

}  // namespace

Command add_compare_command(CommandLine& program) {
    const auto words = std::make_shared<CompareWords>();
    CommandLine command =
        program.subcommand("compare", "Compare two images (.npy or .png) or two directories of them");
    command.required("A", words->a, "an image or a directory");
    command.required("B", words->b, "another");
    command.option("--html", words->html,
                   "write a page with both, their difference and the first pixels that differ");
    command.option("--out", words->out, "the directory for the error images");
    return {command, [words] {
                return compare_files({words->a, words->b, words->html, words->out}, std::cout);
            }};
}

}  // namespace crevice
