// A chapter: one file NN_topic.cpp that holds one function and one static Chapter naming it, which is all it
// takes to be part of `crevice chapter NN` and, with chapter_main.cpp, to be an executable of its own:
//
//     const Chapter kChapter07("07", "raw_ao", "Raw ambient occlusion", raw_ao);
//
// The object files must be linked directly: from a static library the linker would leave them out.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/notebook.h"

namespace crevice {

struct Chapter {
    // Makes itself known to all_chapters(). The texts must outlive the program: literals.
    Chapter(const char* chapter_number, const char* chapter_topic, const char* chapter_title,
            void (*run_chapter)(Notebook& book));
    Chapter(const Chapter&) = delete;
    Chapter& operator=(const Chapter&) = delete;

    const char* number;           // two digits
    const char* topic;            // snake_case
    const char* title;            // plain text
    void (*run)(Notebook& book);  // puts out what its cells show

    std::string name() const { return std::string(number) + "_" + topic; }
    // Its cells and its translation, as they are part of the program. Throws UsageError for a source in another form.
    ChapterSource source() const;
    // The title, and its translation where there is one.
    BookText book_title() const;
};

// Every chapter of this program, by number.
std::vector<const Chapter*> all_chapters();

}  // namespace crevice
