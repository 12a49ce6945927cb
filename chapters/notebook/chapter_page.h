// A chapter's page: OUT/NN_topic.html, one file that opens offline, with its pictures, their values, the mathematics
// and the colours of the code inside.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "chapters/notebook/book_contents.h"
#include "chapters/notebook/cells.h"

namespace crevice {

struct ChapterPage {
    std::string name;  // NN_topic
    BookText title;    // plain text
    std::string file;  // the source, from the repository's root
    int failed_checks = 0;
};

std::string chapter_page(const ChapterPage& page, const std::vector<NotebookCell>& cells,
                         const std::vector<BookEntry>& chapters, BookLanguage language);

// The number of failed checks that a page tells of itself, -1 where the text is no such page. It stands in the head, before
// anything long: this many of the page's first bytes suffice.
inline constexpr std::size_t kFailedChecksWithin = 1024;
int failed_checks_in(const std::string& page);

}  // namespace crevice
