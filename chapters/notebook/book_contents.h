// The list of chapters that every page of the book carries.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/cells.h"

namespace crevice {

struct BookEntry {
    std::string name;  // NN_topic; its page is NAME.html
    BookText title;    // plain text
    int failed_checks = 0;
};

// A text as HTML, in both languages where there are two: `inline_html` makes <span>, for inside a sentence.
std::string bilingual_html(const BookText& html, bool inline_html);
// The same of plain text, inline.
std::string plain_html(const BookText& text);

// <nav>: the book's name, the languages where some title has two, the chapters in their parts; the one named `here` is
// marked, and failed checks are said.
std::string contents_html(const std::vector<BookEntry>& chapters, const std::string& here);

}  // namespace crevice
