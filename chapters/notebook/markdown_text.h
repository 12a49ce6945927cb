// A notebook as Markdown, and the pieces of that which Jupyter notebooks share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "chapters/notebook/cells.h"

namespace crevice {

// GitHub-flavoured Markdown; pictures are linked as NAME.png beside the file.
std::string markdown_from_cells(const std::vector<NotebookCell>& cells, BookLanguage language);

// What a cell put out.
std::string output_markdown(const Output& output, BookLanguage language);

// The code of a cell between fences; that of the setup folded.
std::string code_markdown(const SourceCell& cell);

}  // namespace crevice
