// The slices of one texel under the visibility bitmask.
#pragma once

#include <string>
#include <vector>

#include "chapters/diagrams/sector_section.h"
#include "chapters/props/switched_ao.h"

namespace crevice {

// The texel that the chapters follow; where a seed closes nothing there, the darkest one near it.
Texel shaded_texel(const Image<float>& ao);

std::vector<SliceSectors> sectors_of_texel(const AoInputs& inputs, const VbaoSettings& settings, Texel at);

// A row for each: number, its bits from the positive side's horizon to the negative side's, how many are closed, what it
// loses.
std::vector<std::vector<std::string>> sector_rows(const std::vector<SliceSectors>& slices);

}  // namespace crevice
