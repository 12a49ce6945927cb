#include "chapters/commands/run_chapters.h"

#include <exception>
#include <iostream>

#include "chapters/notebook/notebook_page.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

NotebookSection run_chapter(const Chapter& chapter, const NotebookOptions& options) {
    Notebook book(options, chapter.name());
    try {
        chapter.run(book);
    } catch (const std::exception& error) {
        book.check("chapter " + chapter.name() + " runs to its end", false, error.what());
    }
    if (book.cells().empty()) book.check("chapter " + chapter.name() + " writes something", false);
    book.write_files();
    std::cout << chapter.name() << ": " << book.checks() - book.failed_checks() << " of " << book.checks()
              << " checks hold\n";
    return {chapter.name(), chapter.title, book.html(), book.failed_checks()};
}

}  // namespace

std::vector<const Chapter*> chosen_chapters(const std::string& which) {
    const std::vector<const Chapter*> chapters = all_chapters();
    if (which == "all") return chapters;
    std::string known;
    for (const Chapter* chapter : chapters) {
        const bool by_number = which == chapter->number || "0" + which == chapter->number;
        if (by_number || which == chapter->topic || which == chapter->name()) return {chapter};
        known += " " + chapter->name();
    }
    throw UsageError("chapter: there is no such chapter (" + which + "); give all or one of" + known);
}

int run_chapters(std::span<const Chapter* const> chapters, const NotebookOptions& options) {
    std::vector<NotebookSection> sections;
    int failed_checks = 0;
    for (const Chapter* chapter : chapters) {
        sections.push_back(run_chapter(*chapter, options));
        failed_checks += sections.back().failed_checks;
    }
    const std::filesystem::path page = options.out / "index.html";
    write_file_atomically(page, notebook_page(sections));
    if (failed_checks > 0) {
        std::cout << "failed:";
        for (const NotebookSection& section : sections) {
            if (section.failed_checks > 0)
                std::cout << " " << section.name << " (" << section.failed_checks << ")";
        }
        std::cout << "\n";
    }
    std::cout << page.string() << std::endl;
    return static_cast<int>(failed_checks > 0 ? ExitCode::check_failed : ExitCode::done);
}

}  // namespace crevice
