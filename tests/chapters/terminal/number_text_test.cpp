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

TEST_CASE("a number is the whole text or none") {
    CHECK(number_in("3") == 3.0);
    CHECK(number_in("-0.25") == -0.25);
    for (const char* other : {"", " 3", "3 ", "3px", "many"}) {
        CAPTURE(other);
        CHECK_FALSE(number_in(other));
    }
}

TEST_CASE("counted: one alone is singular") {
    CHECK(counted(0, "thread") == "0 threads");
    CHECK(counted(1, "thread") == "1 thread");
    CHECK(counted(2, "thread") == "2 threads");
    CHECK(counted(1, "pixel is", "pixels are") == "1 pixel is");
    CHECK(counted(2, "pixel is", "pixels are") == "2 pixels are");
}
