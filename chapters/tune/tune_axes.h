// What `crevice tune` may change of a method: each number of its row and of its denoiser's, over the range that the row
// states, as far as a default says how large it may sensibly be.
// Left alone: the seed, which is noise; words and switches, whose first value is the cure of an artifact; numbers without
//         a scale (a default of 0 and no upper end)
#pragma once

#include <string>
#include <vector>

#include "ssao/methods/method.h"

namespace crevice {

// One of the numbers that are searched.
struct TuneAxis {
    std::string name;            // of the parameter
    std::string unit;            // as its row has it; lengths are for scenes whose length_unit is 1
    double standard = 0;         // its default
    std::vector<double> values;  // the only ones there are, rising; empty: anything from `low` to `high`
    double low = 0, high = 0;
    bool geometric = false;  // between them, equal steps are equal ratios
    bool length = false;     // in scene units

    // The value at a share of the way, [0, 1], rounded to what is typed behind --param; monotonic.
    double at(double share) const;
    // The share that gives the value, or the nearest.
    double share_of(double value) const;
};

// The axes of a method whose question is about rays of this length: `radius` is searched from half of it to twice.
std::vector<TuneAxis> tune_axes(const Method& method, double radius);

// One value an axis.
using TuneSetting = std::vector<double>;

TuneSetting standard_setting(const std::vector<TuneAxis>& axes);

// The method's defaults for a scene with these values and a seed. The result is not yet validated.
MethodSettings settings_with(const Method& method, const std::vector<TuneAxis>& axes,
                             const TuneSetting& setting, double length_unit, std::uint32_t seed);

// "--param samples=8 --param radius=0.4": those that are not the defaults, lengths times length_unit; empty where all are.
std::string param_words(const std::vector<TuneAxis>& axes, const TuneSetting& setting, double length_unit);

}  // namespace crevice
