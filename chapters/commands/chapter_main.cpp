// The main function of a chapter that is an executable of its own.
#include <iostream>

#include <CLI/CLI.hpp>

#include "chapters/commands/chapter_command.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace {

int run(int argc, char** argv) {
    const std::vector<const crevice::Chapter*> chapters = crevice::all_chapters();
    crevice::NotebookOptions options;
    std::string out = options.out.string(), size;
    CLI::App app(chapters.empty() ? "No chapter is linked into this program." : chapters.front()->title);
    app.add_option("--out", out, "the directory for pictures and pages")->capture_default_str();
    app.add_option("--size", size, "size of the pictures in pixels, WxH");
    app.add_option("--seed", options.seed, "seed of the samples")->capture_default_str();
    app.add_flag("--step", options.step, "wait for Enter after each cell");
    app.add_flag("--quiet", options.quiet, "say only which checks fail");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : static_cast<int>(crevice::ExitCode::usage);
    }
    options.out = out;
    if (!size.empty()) options.size = crevice::parse_size("--size", size);
    return crevice::run_chapters(chapters, options);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const crevice::Error& error) {
        std::cerr << error.what() << "\n";
        return static_cast<int>(error.code);
    } catch (const std::exception& error) {
        std::cerr << "the chapter ended early (" << error.what() << "); please report this\n";
        return static_cast<int>(crevice::ExitCode::check_failed);
    }
}
