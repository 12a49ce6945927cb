#include "chapters/sweep/error_terms.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("error_terms: T to S, S to C and C to frame add up") {
    const std::vector<SweepErrorPart> parts = {{"depth buffer", 0.01, 0.03, 0.0001},
                                               {"definition", 0.02, 0.05, -0.0003},
                                               {"half size", 0.001, 0.02, 0.0005},
                                               {"sampling", 0, 0.04, 0.002},
                                               {"blur, bias", -0.002, 0.01, -0.0004}};
    const ErrorTerms terms = error_terms(parts);
    CHECK(terms.floor_bias() == doctest::Approx(0.03));
    CHECK(terms.frame_share == doctest::Approx(0.0021));
    CHECK(terms.frame_bias == doctest::Approx(-0.001));
    REQUIRE(largest_part(parts) != nullptr);
    CHECK(largest_part(parts)->step == "sampling");
    CHECK(largest_part({{"blur", 0, 0, -1}}) == nullptr);
}
