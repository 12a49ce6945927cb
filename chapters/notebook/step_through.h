// Stepping through a chapter in the terminal: what `crevice chapter NN --step` asks after each cell.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "chapters/notebook/cells.h"

namespace crevice {

// What the reader decided; `run_again` is name=value.
struct StepAnswer {
    enum class Kind { go_on, run_again, quit, never_ask };
    Kind kind = Kind::go_on;
    std::string word;
};

// Asks until the reader goes on, changes a parameter or quits: Enter goes on; p X Y prints what every picture shows
// at a pixel; v NAME previews one in the terminal, `columns` wide; s NAME FILE saves one, as .png or .npy; set
// NAME=VALUE; q quits. Where the answers end, nothing is asked again.
StepAnswer asked(const std::vector<NotebookCell>& cells, std::istream& answers, std::ostream& terminal);

}  // namespace crevice
