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

Command add_compare_command(CLI::App& program) {
    const auto words = std::make_shared<CompareWords>();
    CLI::App* const command =
        program.add_subcommand("compare", "Compare two images (.npy or .png) or two directories of them");
    command->add_option("A", words->a, "an image or a directory")->required();
    command->add_option("B", words->b, "another")->required();
    command->add_option("--html", words->html,
                        "write a page with both, their difference and the first pixels that differ");
    command->add_option("--out", words->out, "the directory for the error images")->capture_default_str();
    return {command, [words] {
                return compare_files({words->a, words->b, words->html, words->out}, std::cout);
            }};
}

}  // namespace crevice
