#include "chapters/notebook/chapter.h"

#include <algorithm>

namespace crevice {

namespace {

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

std::vector<const Chapter*> all_chapters() {
    std::vector<const Chapter*> chapters = known_chapters();
    std::sort(chapters.begin(), chapters.end(),
              [](const Chapter* a, const Chapter* b) { return a->name() < b->name(); });
    return chapters;
}

}  // namespace crevice
