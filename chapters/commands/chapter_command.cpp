// `crevice chapter`
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/notebook_flags.h"
#include "chapters/commands/run_chapters.h"

namespace crevice {

namespace {

struct ChapterWords {
    std::string which;
    NotebookWords notebook;
};

}  // namespace

Command add_chapter_command(CommandLine& program) {
    const auto words = std::make_shared<ChapterWords>();
    CommandLine chapter =
        program.subcommand("chapter", "Run a chapter, or all, and write its pictures and OUT/index.html");
    chapter.required("WHICH", words->which, "a number such as 07, or all");
    add_notebook_flags(chapter, words->notebook);
    return {chapter, [words] {
                return run_chapters(chosen_chapters(words->which), notebook_options_of(words->notebook));
            }};
}

}  // namespace crevice
