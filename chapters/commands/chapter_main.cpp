// The main function of a chapter that is an executable of its own.
#include "chapters/commands/notebook_flags.h"
#include "chapters/commands/own_chapter.h"
#include "chapters/commands/run_chapters.h"
#include "chapters/terminal/exit_code.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/worker_placement.h"

namespace {

using namespace crevice;

int run(int argc, char** argv) {
    const std::vector<const Chapter*> chapters = chosen_chapters(own_chapter());
    CommandLine program(chapters.front()->title);
    NotebookWords words;
    add_notebook_flags(program, words);
    if (!program.parse(argc, argv)) return static_cast<int>(ExitCode::done);
    return run_chapters(chapters, notebook_options_of(words));
}

}  // namespace

int main(int argc, char** argv) {
    keep_workers_off_caller();
    return exit_code_of([&] { return run(argc, argv); });
}
