// A notebook's cells as text: for the terminal, as Markdown and as a Jupyter notebook.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "chapters/notebook/cells.h"

namespace crevice {

// One cell as plain text that ends in a newline; `directory` is where its pictures lie. With `colour`,
// headings and check marks carry ANSI colours.
std::string terminal_text(const Cell& cell, const std::filesystem::path& directory, bool colour);

// GitHub-flavoured Markdown; pictures are linked as NAME.png beside the file.
std::string markdown_from_cells(const std::vector<Cell>& cells);

// A Jupyter notebook, nbformat 4.5, with the pictures inside. Cell ids are NAME-1, NAME-2 ... so that they
// are stable.
std::string jupyter_from_cells(const std::vector<Cell>& cells, const std::string& name);

// Whether every cell of a table's column reads as a number, so that it is set flush right.
bool is_numeric_column(const TableCell& table, std::size_t column);

}  // namespace crevice
