// How the tutorials' methods fetch their inputs.
#pragma once

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

inline constexpr AoFetch kXjunFetch = {DepthSource::view_depth, false, 0.5f};
inline constexpr AoFetch kLunaFetch = {DepthSource::ndc_depth, true, 0.5f};

// As the shaders are published: edges mixed, the sky's depth as it is stored.
inline AoFetch published(AoFetch fetch) {
    fetch.edge_texels = EdgeTexels::mixed;
    fetch.sky_depth = SkyDepth::as_stored;
    return fetch;
}

}  // namespace crevice
