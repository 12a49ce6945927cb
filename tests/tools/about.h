// Comparison of numbers of any size. doctest's own Approx adds 1 to their size, so that small ones are equal
// to nearly anything.
#pragma once

#include <doctest/doctest.h>

namespace crevice {

// CHECK(value == about(expected, 1e-6)): equal to within that share of the larger of the two.
inline doctest::Approx about(double expected, double relative) {
    return doctest::Approx(expected).epsilon(relative).scale(0);
}

}  // namespace crevice
