// `crevice chapter NN|all`: runs chapters and writes their notebooks.
#pragma once

#include <span>
#include <string>

#include "chapters/notebook/chapter.h"

namespace crevice {

// `which` is a number (7 or 07), a topic, a name (07_raw_ao) or `all`. Throws UsageError listing what there
// is.
std::vector<const Chapter*> chosen_chapters(const std::string& which);

// Runs the chapters in order, each into OUT/NN_topic, and writes OUT/index.html with all of them; the last
// line on the terminal is its path. A chapter that throws counts as failed and the others go on. Returns 0,
// or 1 when a check failed or a chapter threw. Throws OutputError when a page cannot be written.
int run_chapters(std::span<const Chapter* const> chapters, const NotebookOptions& options);

}  // namespace crevice
