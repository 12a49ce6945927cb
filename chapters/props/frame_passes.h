// The lab's frame as a graph of its passes.
#pragma once

#include <vector>

#include "chapters/diagrams/pass_graph.h"
#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// With X_Jun's or Luna's AO, each image with its size, format and readers.
std::vector<GraphPass> frame_passes(const AoInputs& inputs);

}  // namespace crevice
