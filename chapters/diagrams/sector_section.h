// What chapter 19's visibility bitmask finds in a slice, over a cut through the depth buffer. All numbers are the kernel's.
#pragma once

#include <cstdint>
#include <string>

#include "ssao/inputs/ao_inputs.h"
#include "ssao/methods/vbao.h"

namespace crevice {

// A slice of the visibility bitmask.
struct SliceSectors {
    std::uint32_t closed = 0;  // a bit each, from the positive side's horizon to the negative side's
    float lost = 0;            // what the slice takes, [0, 1]
};
SliceSectors slice_sectors(const AoInputs& inputs, const VbaoSettings& settings, int x, int y, int number);
std::string sectors_diagram(const AoInputs& inputs, const VbaoSettings& settings, int x, int y, int number,
                            const std::string& title);

}  // namespace crevice
