// A chapter's source from a text; without one, a single cell that any line belongs to.
#pragma once

#include <limits>
#include <string>

#include "chapters/notebook/notebook.h"

namespace crevice {

inline ChapterSource notebook_source(const std::string& name, const std::string& text) {
    ChapterSource source;
    source.name = name;
    source.file = "chapters/" + name + ".cpp";
    source.cells = percent_cells(text, source.file);
    if (text.empty())
        source.cells = {{"all", SourceCell::Kind::code, 0, std::numeric_limits<int>::max(), ""}};
    return source;
}

}  // namespace crevice
