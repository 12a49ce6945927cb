// Texels that chapter 14 speaks of, and how many of their points are hidden.
#pragma once

#include "chapters/props/switched_ao.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// Of the texels in the middle half of the map that are quite open by their points' depths, the one that is least open by
// the depth of p.
inline Texel most_mistaken(const Image<float>& by_point, const Image<float>& by_centre) {
    const int quarter = by_point.size.width / 4;
    Texel worst;
    float least = 1;
    for (int y = 0; y < by_point.size.height; ++y) {
        for (int x = quarter; x < by_point.size.width - quarter; ++x) {
            if (by_point.at(x, y) < 1 || by_centre.at(x, y) >= least) continue;
            worst = {x, y};
            least = by_centre.at(x, y);
        }
    }
    return worst;
}

inline int hidden_points(const Explanation& texel) {
    int count = 0;
    for (const ExplainedSample& sample : texel.samples) count += sample.contribution > 0 ? 1 : 0;
    return count;
}

}  // namespace crevice
