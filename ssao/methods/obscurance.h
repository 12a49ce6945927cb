// What the obscurance methods, Alchemy and SAO, have in common.
#pragma once

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// Whether a fetched point is one that can occlude: not in front of the near plane, and not the background,
// which neither paper rules out. `inputs` must be fetched with MapBorder::far.
template <class F>
CREVICE_INLINE Mask<F> can_occlude(const AoInputs& inputs, F z) {
    const float background = inputs.depth_map.pixels.front();
    return (z > F(inputs.near_plane)) & (z < F(background));
}

}  // namespace crevice
