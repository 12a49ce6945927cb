// The middle of many values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace crevice {

// Of an even number the upper of the two in the middle. At least one value; none is NaN.
inline double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace crevice
