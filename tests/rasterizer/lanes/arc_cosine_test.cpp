#include "rasterizer/lanes/arc_cosine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("arc cosine: within its stated error of libm's over all of [-1, 1], its ends exact to a rounding") {
    double largest = 0;
    constexpr int kSteps = 200000;
    for (int i = 0; i <= kSteps; ++i) {
        const float x = static_cast<float>(2.0 * i / kSteps - 1);
        largest = std::max(largest, std::fabs(double{arc_cosine(x)} - std::acos(double{x})));
    }
    CHECK(largest < 5e-7);
    CHECK(arc_cosine(1.0f) == 0);
    CHECK(arc_cosine(-1.0f) == doctest::Approx(3.14159265358979).epsilon(1e-7));
}

TEST_CASE("arc cosine: what rounding takes beyond [-1, 1] is taken for its end") {
    CHECK(arc_cosine(std::nextafter(1.0f, 2.0f)) == 0);
    CHECK(arc_cosine(7.0f) == 0);
    CHECK(arc_cosine(-7.0f) == arc_cosine(-1.0f));
    CHECK(arc_cosine(std::numeric_limits<float>::quiet_NaN()) == 0);
}
