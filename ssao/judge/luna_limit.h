// What the tutorials' estimator tends to when it is given ever more samples: the method itself without its
// noise.
// How:    accessibility before the exponent, averaged over seeds in double; then the exponent. Each seed has
//         its own offset lengths and random map, so the mean is over all that the method could have drawn.
// Out:    picture of the AO map's size; background 1, error 0
// Cost:   one luna_occlusion() a seed
#pragma once

#include <functional>

#include "ssao/judge/seed_limit.h"
#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// `seeds` as in seed_limit(). Settings' seed is not looked at; samples are, though they change only how fast the mean
// settles. Throws UsageError.
ReferenceImage luna_limit(const AoInputs& inputs, const LunaSettings& settings, int seeds,
                          const Run& run = {}, const std::function<void(long long)>& on_progress = {});

}  // namespace crevice
