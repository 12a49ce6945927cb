// What a chapter says in the terminal.
#pragma once

#include <filesystem>
#include <string>

#include "chapters/notebook/cells.h"

namespace crevice {

struct TerminalStyle {
    std::filesystem::path directory;  // where the pictures lie
    BookLanguage language = BookLanguage::en;
    bool colour = false;  // headings, marks of checks and captions in ANSI colours
};

// Markdown as a terminal shows it: without tags of folded parts, headings in bold, formulas as plain_math() has them.
std::string terminal_prose(const std::string& markdown, bool colour);

// One output as plain text that ends in a newline.
std::string terminal_text(const Output& output, const TerminalStyle& style);

}  // namespace crevice
