// What settings are refused with: UsageError "MEMBER: must lie in RANGE (value); choose another value".
#pragma once

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// A length in [0, inf), scene units.
void require_length(const char* member, double value);
// A radius, scene units: at most kLargestRadius, whose square still is a float.
inline constexpr double kLargestRadius = 1e15;
// Of a smaller one the inverse may be infinite: a kernel takes it for 0, where nothing occludes.
inline constexpr float kSmallestRadius = 1e-30f;
void require_radius(double value);
void require_within(const char* member, double value, double lowest, double highest);

// The members that the settings of nearly every method have.
template <class S>
void require_common(const S& settings) {
    require_radius(settings.radius);
    require_within("exponent", settings.exponent, 0, 64);
    ao_map_size({1, 1}, settings.ao_scale);  // which refuses what is no scale
}

}  // namespace crevice
