#include "ssao/judge/percentile.h"

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"

using namespace crevice;

TEST_CASE("percentile: the nearest rank") {
    const std::vector<double> values = {4, 1, 3, 2};
    CHECK(percentile(values, 1) == 1);
    CHECK(percentile(values, 25) == 1);
    CHECK(percentile(values, 26) == 2);
    CHECK(percentile(values, 50) == 2);
    CHECK(percentile(values, 75) == 3);
    CHECK(percentile(values, 99) == 4);
    CHECK(percentile(values, 100) == 4);
    CHECK_THROWS_AS(percentile({}, 50), UsageError);
    CHECK_THROWS_AS(percentile(values, 0), UsageError);
    CHECK_THROWS_AS(percentile(values, 101), UsageError);
}
