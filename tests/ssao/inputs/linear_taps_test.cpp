#include "ssao/inputs/linear_taps.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("linear taps: equal sizes give the pixel itself") {
    for (const int count : {1, 2, 7, 8, 801, 32768}) {
        CAPTURE(count);
        const LinearTaps taps(count, count);
        int others = 0;
        for (int i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            others += taps.first[at] != i || taps.weight_of_second[at] != 0;
        }
        CHECK(others == 0);
    }
}

TEST_CASE("linear taps: half of an even size is the mean of two, exactly") {
    for (const int count : {1, 2, 5, 400, 16384}) {
        CAPTURE(count);
        const LinearTaps taps(count, 2 * count);
        int others = 0;
        for (int i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            others +=
                taps.first[at] != 2 * i || taps.second[at] != 2 * i + 1 || taps.weight_of_second[at] != 0.5f;
        }
        CHECK(others == 0);
    }
}

TEST_CASE("linear taps: twice the size weighs by quarters and repeats the ends") {
    const LinearTaps taps(8, 4);
    const auto eight = [](const auto& padded) { return std::vector(padded.begin(), padded.begin() + 8); };
    CHECK(eight(taps.first) == std::vector<std::int32_t>{0, 0, 0, 1, 1, 2, 2, 3});
    CHECK(eight(taps.second) == std::vector<std::int32_t>{0, 1, 1, 2, 2, 3, 3, 3});
    CHECK(eight(taps.weight_of_second) ==
          std::vector<float>{.75f, .25f, .75f, .25f, .75f, .25f, .75f, .25f});
}

TEST_CASE("linear taps: any two sizes against the sampler's definition in double") {
    for (int count = 1; count <= 40; ++count) {
        for (int source = 1; source <= 40; ++source) {
            const LinearTaps taps(count, source);
            int wrong = 0;
            for (int i = 0; i < count; ++i) {
                const auto at = static_cast<std::size_t>(i);
                const double position = (i + 0.5) * source / count - 0.5;
                const double whole = std::floor(position + 1e-9);
                const auto clamped = [&](double a) { return std::fmin(std::fmax(a, 0), source - 1); };
                const float weight = taps.weight_of_second[at];
                wrong += taps.first[at] != clamped(whole) || taps.second[at] != clamped(whole + 1) ||
                         weight < 0 || weight >= 1 ||
                         std::fabs(static_cast<double>(weight) - (position - whole)) > 1e-7;
            }
            CAPTURE(count);
            CAPTURE(source);
            REQUIRE(wrong == 0);
        }
    }
}

TEST_CASE("linear taps: whole groups of pixels, the padding inside the source too") {
    for (const int count : {1, 3, 16, 17, 401}) {
        for (const int source : {1, 2, 801}) {
            CAPTURE(count);
            CAPTURE(source);
            const LinearTaps taps(count, source);
            const auto padded = static_cast<std::size_t>(round_up(count, kRowAlignment));
            CHECK(taps.first.size() == padded);
            CHECK(taps.second.size() == padded);
            CHECK(taps.weight_of_second.size() == padded);
            int outside = 0;
            for (std::size_t i = 0; i < padded; ++i) {
                outside += taps.first[i] < 0 || taps.first[i] >= source || taps.second[i] < 0 ||
                           taps.second[i] >= source;
            }
            CHECK(outside == 0);
        }
    }
}
