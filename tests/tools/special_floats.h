// The floats that every kernel must survive.
#pragma once

#include <limits>

namespace crevice {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

}  // namespace crevice
