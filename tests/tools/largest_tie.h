// How near to a wanted coverage an alpha plane can come.
#pragma once

#include <algorithm>
#include <map>

#include "rasterizer/base/image.h"

namespace crevice {

// How many texels at most have the same alpha above 0: they pass a test together.
inline int largest_tie(const Image<float>& alpha) {
    std::map<float, int> counts;
    int largest = 0;
    for (int y = 0; y < alpha.size.height; ++y) {
        for (int x = 0; x < alpha.size.width; ++x) {
            const float value = alpha.at(x, y);
            if (value > 0) largest = std::max(largest, ++counts[value]);
        }
    }
    return largest;
}

// By how much the part of the texels that pass may miss what is wanted.
inline double coverage_slack(const Image<float>& alpha) {
    return (0.5 * largest_tie(alpha) + 0.5) / (alpha.size.width * alpha.size.height) + 1e-9;
}

}  // namespace crevice
