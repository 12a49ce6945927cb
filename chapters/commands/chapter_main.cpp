// The main function of a chapter that is an executable of its own.
#include <CLI/CLI.hpp>

#include "chapters/commands/notebook_flags.h"
#include "chapters/commands/run_chapters.h"
#include "chapters/terminal/exit_code.h"
#include "rasterizer/base/error.h"

namespace {

using namespace crevice;

int run(int argc, char** argv) {
    const std::vector<const Chapter*> chapters = all_chapters();
    CLI::App app(chapters.empty() ? "No chapter is linked into this program." : chapters.front()->title);
    NotebookWords words;
    add_notebook_flags(app, words);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
    }
    return run_chapters(chapters, notebook_options_of(words));
}

}  // namespace

int main(int argc, char** argv) {
    return exit_code_of([&] { return run(argc, argv); });
}
