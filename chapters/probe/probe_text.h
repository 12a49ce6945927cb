// A probed pixel as text for a terminal: the answer first, then a table a pass.
#pragma once

#include <string>

#include "chapters/probe/pixel_probe.h"

namespace crevice {

// Numbers have the fewest digits that read back as the same float. With a name of kProbedPasses that pass alone.
std::string probe_text(const PixelProbe& probe, const std::string& pass = "");

}  // namespace crevice
