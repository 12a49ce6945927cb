// How alike the errors of neighbouring texels are: in bands they are, in grain they are not.
#pragma once

#include <cstdint>

#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// [-1, 1]; how much of the square of an error a texel has in common with the next one to the right: 1 in bands, 0 in
// grain.
double likeness_of_neighbours(const Image<float>& error);

// Of maps of several seeds, each with its texels unturned (bands) and turned (grain).
struct BandsAndGrain {
    double bands = 0, grain = 0;  // means over the seeds
    int more_alike_in_bands = 0;  // seeds
};
// The seeds first_seed, first_seed + 1 and so on, with the lengths and the exponent of `settings`; an error is the
// distance from `limit`, which luna_limit() makes of the same settings.
BandsAndGrain bands_and_grain(const AoInputs& inputs, const LunaSettings& settings, const Image<float>& limit,
                              std::uint32_t first_seed, int seeds);

}  // namespace crevice
