// `crevice merge`
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/report/sweep_report.h"
#include "chapters/sweep/merge_sweep.h"
#include "chapters/terminal/output_directory.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// As they were typed.
struct MergeWords {
    std::vector<std::string> directories;
    std::optional<std::string> out;
};

int run(const MergeWords& words) {
    if (words.directories.empty())
        throw UsageError("crevice merge: no directory; give those that crevice sweep wrote");
    const std::vector<std::filesystem::path> directories(words.directories.begin(), words.directories.end());
    const std::filesystem::path out = words.out ? named_directory("--out", *words.out) : directories.front();
    const Merged all = merged(directories);
    const int exit_code = write_merged(all, out, std::cout);
    write_sweep_report(all.results, out);
    std::cout << (out / "report.html").string() << "\n";
    return exit_code;
}

}  // namespace

Command add_merge_command(CommandLine& program) {
    const auto words = std::make_shared<MergeWords>();
    CommandLine merge = program.subcommand("merge",
                                           "Put the results of a sweep's shards together: results.json, .csv "
                                           "and .md, and report.html; says what is missing");
    merge.option("DIR", words->directories, "directories that crevice sweep wrote");
    merge.option("--out", words->out, "the directory for the results; default: the first DIR");
    return {merge, [words] { return run(*words); }};
}

}  // namespace crevice
