// The flags of whatever runs chapters: --out --size --seed --scene --param --cell --lang --step --quiet.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chapters/notebook/notebook.h"
#include "chapters/terminal/command_line.h"

namespace crevice {

// As they were typed.
struct NotebookWords {
    std::string out = "out", seed = "1", scene, cell, language = "both";
    std::vector<std::string> parameters;
    std::optional<std::string> size;
    bool step = false, quiet = false;
};
void add_notebook_flags(CommandLine& command, NotebookWords& words);
// Throws UsageError.
NotebookOptions notebook_options_of(const NotebookWords& words);

}  // namespace crevice
