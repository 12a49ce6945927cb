// OUT/index.html: the book's cover, with the chapters that are there.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/book_contents.h"

namespace crevice {

// The preface (chapters/preface.md), the table of sources (sources.h) and the chapters.
std::string book_index(const std::vector<BookEntry>& chapters, BookLanguage language);

}  // namespace crevice
