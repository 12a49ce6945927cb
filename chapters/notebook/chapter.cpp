#include "chapters/notebook/chapter.h"

#include <algorithm>
#include <limits>

#include "chapters/notebook/embedded_files.h"

namespace crevice {

namespace {

constexpr const char* kTerms = "chapters/zh/terms.md";

// Inside a function, so that it exists before the first static Chapter asks for it.
std::vector<const Chapter*>& known_chapters() {
    static std::vector<const Chapter*> chapters;
    return chapters;
}

}  // namespace

Chapter::Chapter(const char* chapter_number, const char* chapter_topic, const char* chapter_title,
                 void (*run_chapter)(Notebook& book))
    : number(chapter_number), topic(chapter_topic), title(chapter_title), run(run_chapter) {
    known_chapters().push_back(this);
}

ChapterSource Chapter::source() const {
    ChapterSource source;
    source.name = name();
    source.file = "chapters/" + name() + ".cpp";
    source.cells = percent_cells(embedded_file(source.file).value_or(""), source.file);
    // Not a file of the repository, as in tests: whatever the function puts out stands in one cell.
    if (source.cells.empty())
        source.cells = {{"all", SourceCell::Kind::setup, 0, std::numeric_limits<int>::max(), ""}};
    const std::string chinese = "chapters/zh/" + name() + ".md";
    if (const auto text = embedded_file(chinese)) {
        source.chinese = translation_from(*text, chinese);
        // Words that chapters share; a chapter's own translation goes before them.
        const Translation terms = translation_from(embedded_file(kTerms).value_or(""), kTerms);
        source.chinese.texts.insert(terms.texts.begin(), terms.texts.end());
    }
    return source;
}

BookText Chapter::book_title() const {
    const Translation chinese = source().chinese;
    const auto translated = chinese.texts.find(title);
    return {title, translated == chinese.texts.end() ? "" : translated->second};
}

std::vector<const Chapter*> all_chapters() {
    std::vector<const Chapter*> chapters = known_chapters();
    std::sort(chapters.begin(), chapters.end(),
              [](const Chapter* a, const Chapter* b) { return a->name() < b->name(); });
    return chapters;
}

}  // namespace crevice
