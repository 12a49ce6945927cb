// AO inputs in double, for a judge of rounding errors.
#pragma once

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// The inputs with AoInputs::in_double set, so that kernels run in double. `seen` is what the pixels of their picture
// show in double; null: what the inputs themselves hold, so that only the kernel's own roundings are missing. What lies
// beyond the picture, and the background, stay the floats that they are.
AoInputs in_double(AoInputs inputs, const DoubleGBuffer* seen);

}  // namespace crevice
