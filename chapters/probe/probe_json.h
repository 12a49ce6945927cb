// A probed pixel as a JSON document: schemas/probe.schema.json describes it.
#pragma once

#include <string>

#include "chapters/probe/pixel_probe.h"

namespace crevice {

// Floats have the fewest digits that read back as the same float; what is no finite number is null. With a name of
// kProbedPasses that pass alone; with none, all.
std::string probe_json(const PixelProbe& probe, const std::string& pass = "");

}  // namespace crevice
