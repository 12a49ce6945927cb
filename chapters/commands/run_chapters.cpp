#include "chapters/commands/run_chapters.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>

#include "chapters/notebook/book_index.h"
#include "chapters/notebook/chapter_page.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/no_such.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

// The number of failed checks that a chapter's page on disk tells of; nothing where there is no page.
std::optional<int> failed_checks_on_page(const Chapter& chapter, const NotebookOptions& options) {
    const std::filesystem::path page = options.out / (chapter.name() + ".html");
    if (!std::filesystem::exists(page)) return std::nullopt;
    std::string head(kFailedChecksWithin, '\0');
    std::ifstream stream(page, std::ios::binary);
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    const int failed = failed_checks_in(head);
    return failed < 0 ? std::nullopt : std::optional(failed);
}

// What the contents list: the chapters that have a page, and those that are about to get one.
std::vector<BookEntry> book_entries(std::span<const Chapter* const> running, const NotebookOptions& options) {
    std::vector<BookEntry> entries;
    for (const Chapter* chapter : all_chapters()) {
        const auto on_page = failed_checks_on_page(*chapter, options);
        const bool runs = std::find(running.begin(), running.end(), chapter) != running.end();
        if (on_page || runs) entries.push_back({chapter->name(), chapter->book_title(), on_page.value_or(0)});
    }
    return entries;
}

void write_page(const Chapter& chapter, const Notebook& book, std::span<const Chapter* const> running) {
    const NotebookOptions& options = book.options();
    const ChapterPage page = {chapter.name(), chapter.book_title(), book.file(), book.failed_checks()};
    write_file_atomically(options.out / (chapter.name() + ".html"),
                          chapter_page(page, book.cells(), book_entries(running, options), options.language));
    book.write_files();
}

// For whoever translates the book.
void tell_what_is_untranslated(const Notebook& book) {
    if (book.untranslated().empty()) return;
    std::cerr << "warning: chapters/zh/" << book.name() << ".md lacks\n";
    for (const std::string& heading : book.untranslated()) std::cerr << heading << "\n";
}

// Runs the chapter's function to its end. Its mistakes are failed checks of its own; a reader's wish to leave passes
// through, and so does a disk that is full and, where the reader `tries` a parameter, the refusal of that. Returns whether
// it came to its end.
bool run_to_end(const Chapter& chapter, Notebook& book, bool tries) {
    const std::string claim = "chapter " + chapter.name() + " runs to its end";
    try {
        chapter.run(book);
        book.finish();
        const bool empty = std::all_of(book.cells().begin(), book.cells().end(),
                                       [](const NotebookCell& cell) { return cell.outputs.empty(); });
        if (empty) book.fail("chapter " + chapter.name() + " writes something", "");
        return true;
    } catch (const OutputError&) {
        throw;
    } catch (const std::exception& error) {
        if (tries && dynamic_cast<const UsageError*>(&error) != nullptr) throw;
        book.fail(claim, error.what());
        return false;
    }
}

// Returns the number of failed checks. A reader who steps through may set a parameter: then everything up to the cell
// where that happened runs again in silence, and once more without it where a method refuses it. Of one cell alone, and
// of a chapter that was left, there is no page.
int run_chapter(const Chapter& chapter, NotebookOptions options, std::span<const Chapter* const> running) {
    const std::size_t given = options.words.size();
    for (;;) {
        Notebook book(options, chapter.source());
        bool ended = false, left = false;
        try {
            ended = run_to_end(chapter, book, options.words.size() > given);
            if (options.cell.empty()) write_page(chapter, book, running);
            if (options.language == BookLanguage::zh) tell_what_is_untranslated(book);
        } catch (const LeaveChapter& wish) {
            if (wish.why == LeaveChapter::Why::run_again) {
                options.words.push_back(wish.word);
                options.silent_until = wish.cell;
                continue;
            }
            left = true;
        } catch (const UsageError& refusal) {
            if (options.words.size() == given) throw;
            std::cout << "  " << refusal.what() << "; taken back\n";
            options.words.pop_back();
            continue;
        }
        if (!left && options.cell.empty())
            std::cout << chapter.name() << ": " << book.checks() - book.failed_checks() << " of "
                      << counted(book.checks(), "check") << (book.checks() == 1 ? " holds\n" : " hold\n");
        // What a chapter claims, it claims of its own scenes and parameters; that it runs, of all.
        const bool changed = !options.words.empty() || !options.scene.empty();
        return changed && (ended || left) ? 0 : book.failed_checks();
    }
}

}  // namespace

std::vector<const Chapter*> chosen_chapters(const std::string& which) {
    const std::vector<const Chapter*> chapters = all_chapters();
    if (which == "all") return chapters;
    std::vector<std::string> known = {"all"};
    for (const Chapter* chapter : chapters) {
        const bool by_number = which == chapter->number || "0" + which == chapter->number;
        if (by_number || which == chapter->topic || which == chapter->name()) return {chapter};
        known.push_back(chapter->name());
    }
    throw no_such("chapter", "chapter", which, known);
}

int run_chapters(std::span<const Chapter* const> chapters, const NotebookOptions& options) {
    int failed_checks = 0;
    std::string failed;
    for (const Chapter* chapter : chapters) {
        const int failed_here = run_chapter(*chapter, options, chapters);
        if (failed_here > 0) failed += " " + chapter->name() + " (" + std::to_string(failed_here) + ")";
        failed_checks += failed_here;
    }
    if (!failed.empty()) std::cout << "failed:" << failed << "\n";
    const std::vector<BookEntry> entries = book_entries({}, options);
    if (options.cell.empty() && !entries.empty()) {
        const std::filesystem::path page = options.out / "index.html";
        write_file_atomically(page, book_index(entries, options.language));
        std::cout << page.string() << std::endl;
    }
    return static_cast<int>(failed_checks > 0 ? ExitCode::check_failed : ExitCode::done);
}

}  // namespace crevice
