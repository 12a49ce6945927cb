// What the tutorials' estimator tends to when it is given ever more samples: the method itself without its
// noise.
// How:    accessibility before the exponent, averaged over seeds in double; then the exponent. Each seed has
//         its own offset lengths and random map, so the mean is over all that the method could have drawn.
// Out:    picture of the AO map's size; background 1, error 0
// Cost:   one luna_occlusion() a seed
#pragma once

#include <functional>

#include "ssao/judge/reference_image.h"
#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// The seeds are kFirstLimitSeed on: others than anybody would choose for a picture. `seeds` is at least
// kReplicates (ray_cast_ao.h), rounded up to a multiple of it. Settings' seed is not looked at; samples are,
// though they change only how fast the mean settles. Throws UsageError.
inline constexpr std::uint32_t kFirstLimitSeed = 0x5eed0000u;
ReferenceImage luna_limit(const AoInputs& inputs, const LunaSettings& settings, int seeds,
                          const Run& run = {}, const std::function<void(long long)>& on_progress = {});

}  // namespace crevice
