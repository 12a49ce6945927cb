// What a tile of turns gives neighbouring texels when the map does not fit it.
#pragma once

#include <set>

#include "ssao/methods/hemisphere_samples.h"

namespace crevice {

// How many of the tile's four columns four neighbouring texels read, on average, where a map of so many texels takes the
// tile for one of 1024.
inline double turns_in_four(int texels) {
    int found = 0;
    for (int first = 0; first < texels; ++first) {
        std::set<int> columns;
        for (int i = 0; i < kTurnSide; ++i)
            columns.insert((2 * (first + i) + 1) * 1024 / (2 * texels) % kTurnSide);
        found += static_cast<int>(columns.size());
    }
    return static_cast<double>(found) / texels;
}

}  // namespace crevice
