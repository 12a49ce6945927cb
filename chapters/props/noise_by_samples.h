// How the noise of the tutorials' AO falls with the number of samples.
#pragma once

#include <cstdint>
#include <vector>

#include "chapters/notebook/plot.h"
#include "ssao/inputs/ao_inputs.h"

namespace crevice {

struct NoiseBySamples {
    std::vector<Image<float>> maps;  // without contrast, one for each number of samples
    PlotCurve measured;              // their RMS differences from the limit
    PlotCurve ideal;                 // what the first would fall to if samples were independent: 1 / sqrt(N)
};
// `limit` is what luna_limit() makes of the same, without contrast. Ascending numbers of samples, the first of them 1.
NoiseBySamples noise_by_samples(const AoInputs& inputs, const Image<float>& limit,
                                const std::vector<int>& samples, std::uint32_t seed);

}  // namespace crevice
