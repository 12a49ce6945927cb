// Percentiles by nearest rank: always one of the values, never a mean of two.
// Cost: linear in the number of values.
#pragma once

#include <vector>

namespace crevice {

// The smallest of the values that at least `percent` in 100 of them do not exceed. No NaN among them. Throws
// UsageError when there are none, or for a percent outside [1, 100].
double percentile(std::vector<double> values, int percent);

}  // namespace crevice
