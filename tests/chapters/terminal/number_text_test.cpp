#include "chapters/terminal/number_text.h"

#include <limits>

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("numbers as texts: as many digits as asked for, whatever their size") {
    CHECK(decimal_text(0.5, 3) == "0.500");
    CHECK(decimal_text(-2.675, 0) == "-3");
    CHECK(decimal_text(std::numeric_limits<double>::max(), 9).size() == 309 + 1 + 9);
    CHECK(significant_text(0.5, 3) == "0.5");
    CHECK(significant_text(1234.5, 3) == "1.23e+03");
    CHECK(percent_text(0.12345) == "12.3 %");
    CHECK(percent_text(1) == "100 %");
    CHECK(size_text({1280, 720}) == "1280x720");
}

TEST_CASE("an exact text reads back as the same float") {
    CHECK(exact_text(0.1f) == "0.1");
    CHECK(exact_text(1) == "1");
    CHECK(exact_text(0.10000001f) == "0.10000001");
    CHECK(exact_text(-std::numeric_limits<float>::infinity()) == "-inf");
    CHECK(exact_text(-std::numeric_limits<float>::quiet_NaN()) == "NaN");
}
