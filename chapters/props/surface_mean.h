// The mean of an AO map over what it shows of surfaces: the sky, which is 1 everywhere, would only dilute it.
#pragma once

#include <cmath>

#include "ssao/methods/ao_map.h"

namespace crevice {

inline double mean_over_surfaces(const Image<float>& ao, const AoInputs& inputs) {
    double sum = 0, count = 0;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            if (std::isinf(inputs.view_depth.at(x, y))) continue;
            sum += static_cast<double>(ao.at(x, y));
            count += 1;
        }
    }
    return sum / count;
}
inline double mean_over_surfaces(const RawAo& raw) { return mean_over_surfaces(raw.ao, raw.inputs); }

}  // namespace crevice
