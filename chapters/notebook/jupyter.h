// A chapter as a Jupyter notebook whose cells run: each asks the program for one cell of the chapter, shows its
// pictures and reads its buffers with NumPy.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/cells.h"

namespace crevice {

// nbformat 4.5 for the kernel python3, with all outputs inside. `name` is NN_topic. The cells' ids are the names in the
// source, so that they are stable. `flags`, such as " --size 160x90", are those that the chapter was run with.
std::string jupyter_from_cells(const std::vector<NotebookCell>& cells, const std::string& name,
                               BookLanguage language, const std::string& flags = "");

}  // namespace crevice
