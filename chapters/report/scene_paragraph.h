// A paragraph about one view, made from its figures: what wins at which budget, and why.
// Ties:   errors whose difference is within its 95 % interval; times whose ratio the same setting run twice has, too (A/A), or
//         whose intervals meet. What is a tie is said to be one
#pragma once

#include <string>

#include "chapters/sweep/sweep_figures.h"

namespace crevice {

// Markdown, whole sentences.
std::string scene_paragraph(const ViewFigures& view);

}  // namespace crevice
