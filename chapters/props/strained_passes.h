// The rounding of each pass with near and far plane close to what is seen, and strained: 0.0001 and 10,000,000.
#pragma once

#include <string>
#include <vector>

namespace crevice {

struct StrainedPasses {
    // Pass, unit, mean and 99th percentile at ease, the same strained.
    std::vector<std::vector<std::string>> rows;
    double vertex_ulps = 0;  // the largest error of a vertex's view depth in either view
    // What the depth buffer's rounding costs Luna's method of AO, in the mean.
    double luna_at_ease = 0, luna_strained = 0;
};
// Of the block.
StrainedPasses strained_passes();

}  // namespace crevice
