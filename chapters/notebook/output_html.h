// The outputs of a chapter's cells as HTML.
#pragma once

#include <string>

#include "chapters/notebook/cells.h"

namespace crevice {

// Markdown in both languages, as paragraphs.
std::string prose_html(const BookText& markdown);

std::string output_html(const Output& output);

// C++ with the numbers of its lines beside it.
std::string numbered_code(const std::string& code, int first_line);

}  // namespace crevice
