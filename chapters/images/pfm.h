// Portable float maps: the simplest file of floats that renderers write. http://www.pauldebevec.com/Research/HDR/PFM/
#pragma once

#include <string>

#include "rasterizer/base/npy.h"

namespace crevice {

// "Pf" (one component) or "PF" (three), "WIDTH HEIGHT", a scale whose sign says the order of bytes (negative:
// little-endian; its size is a unit and is not applied), then rows from the lowest up. Throws InputError naming the file
// and what was found.
Planes planes_from_pfm(const std::string& bytes, const std::string& name);

}  // namespace crevice
