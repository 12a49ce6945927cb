// Bands against grain: how alike the errors of neighbouring texels are, and what a blur leaves of them.
#pragma once

#include <cstdint>

#include "chapters/props/switched_ao.h"

namespace crevice {

// [-1, 1]; how much of the square of an error a texel has in common with the next one to the right: 1 in bands, 0 in
// grain.
double likeness_of_neighbours(const Image<float>& error);

// Of the maps of several seeds.
struct MapErrors {
    double likeness = 0;          // of neighbours, the mean
    double raw = 0, blurred = 0;  // root mean square over all texels of all maps
};
struct BandsAndGrain {
    MapErrors bands, grain;       // of maps with their texels unturned and turned
    int more_alike_in_bands = 0;  // seeds
};
// The seeds first_seed, first_seed + 1 and so on, all else as in `shown`. An error is the distance from `limit`, which
// luna_limit() makes of the same, or from the limit that was blurred like the map.
BandsAndGrain bands_and_grain(const SwitchedAo& shown, const Image<float>& limit, std::uint32_t first_seed,
                              int seeds);

}  // namespace crevice
