// What an AO map tends to with ever more samples: the mean over many seeds, with its own noise.
#pragma once

#include <cstdint>
#include <functional>

#include "rasterizer/base/run.h"
#include "ssao/judge/reference_image.h"

namespace crevice {

// The maps of `seeds` seeds from kFirstLimitSeed on, in kReplicates replicates; others than anybody
// would choose for a picture. `map_of` makes the map of a seed before its exponent, which is applied to the mean. Where
// view_depth is +inf the limit is 1. `on_progress` is called with numbers of seeds. Throws UsageError for fewer seeds
// than replicates or more than 2^20.
inline constexpr std::uint32_t kFirstLimitSeed = 0x5eed0000u;
ReferenceImage seed_limit(const Image<float>& view_depth, float exponent, int seeds, const Run& run,
                          const std::function<void(long long)>& on_progress,
                          const std::function<Image<float>(std::uint32_t seed)>& map_of);

}  // namespace crevice
