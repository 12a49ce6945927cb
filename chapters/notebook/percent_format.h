// A chapter's source read as a notebook: the percent format of Jupytext, Spyder and VS Code. A line that begins a
// cell stands at the margin:
//
//     // %% NAME [markdown]          prose: the comment lines that follow, without their "// "
//     // %% NAME                     code
//     // %% NAME tags=["setup"]      code that a reader may skip: pages fold it
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crevice {

struct SourceCell {
    enum class Kind { prose, code, setup };

    std::string name;  // a-z, 0-9 and _; unique in the chapter
    Kind kind = Kind::code;
    int first_line = 0,
        last_line = 0;  // of the file, counted from 1; the line that begins the cell is none of them
    std::string text;   // Markdown, or C++ as it stands there; without empty lines around it
};

// Takes the empty lines before and behind a text away.
void drop_empty_lines_around(std::string& text);

// The cells of a whole file, in order. Without any line that begins a cell, the file is one code cell named "all".
// Throws UsageError, naming file and line: text before the first cell, a cell that is indented, a name that is missing,
// malformed or there twice, an unknown tag, a line of a prose cell that is no comment.
std::vector<SourceCell> percent_cells(std::string_view source, const std::string& file);

}  // namespace crevice
