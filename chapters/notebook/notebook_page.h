// The page that shows notebooks: OUT/index.html, one file that opens offline.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/cells.h"

namespace crevice {

// The cells as HTML, to be put inside a page.
std::string html_from_cells(const std::vector<Cell>& cells);

struct NotebookSection {
    std::string name;   // NN_topic; also the anchor
    std::string title;  // plain text
    std::string html;   // from html_from_cells
    int failed_checks = 0;
};

// The table of sources (sources.h) and all sections, beside a list of contents; a section with a failed check is marked there.
std::string notebook_page(const std::vector<NotebookSection>& sections);

}  // namespace crevice
