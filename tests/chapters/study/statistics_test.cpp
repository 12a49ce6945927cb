#include "chapters/study/statistics.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "rasterizer/base/error.h"

using namespace crevice;

TEST_CASE("median_ranks: the known intervals of 9, 15 and 21 values, and the binomial for all others") {
    struct Known {
        int n, low, high;
        double confidence;
    };
    for (const Known& known : {Known{9, 2, 8, 0.961}, Known{15, 4, 12, 0.965}, Known{21, 6, 16, 0.973},
                               Known{6, 1, 6, 0.969}, Known{5, 1, 5, 0.9375}, Known{1, 1, 1, 0}}) {
        CAPTURE(known.n);
        const MedianRanks ranks = median_ranks(known.n);
        CHECK(ranks.low == known.low);
        CHECK(ranks.high == known.high);
        CHECK(ranks.confidence == doctest::Approx(known.confidence).epsilon(0.001));
    }
    for (int n = 6; n <= 999; ++n) {
        CAPTURE(n);
        const MedianRanks ranks = median_ranks(n);
        CHECK(ranks.low + ranks.high == n + 1);
        CHECK(ranks.confidence >= 0.95);
        // One rank further in would hold the median too rarely.
        double mass = std::pow(0.5, n), below = 0;
        for (int k = 0; k <= ranks.low; ++k) {
            below += mass;
            mass *= static_cast<double>(n - k) / (k + 1);
        }
        CHECK(1 - 2 * below < 0.95);
    }
    // Where 2^-n is no longer a number. Of many, the ranks are n/2 - 0.98 sqrt(n), as the normal distribution has it.
    for (const int n : {1074, 1075, 1100, 10000}) {
        CAPTURE(n);
        const MedianRanks ranks = median_ranks(n);
        CHECK(ranks.low == doctest::Approx(0.5 * n - 0.98 * std::sqrt(n)).epsilon(0.002));
        CHECK(ranks.low + ranks.high == n + 1);
        CHECK(ranks.confidence == doctest::Approx(0.95).epsilon(0.005));
    }
    CHECK_THROWS_AS(median_ranks(0), UsageError);
}

TEST_CASE("median_interval: ordered values, in whatever order they come") {
    std::vector<double> values;
    for (int i = 0; i < 21; ++i) values.push_back((i * 8) % 21 + 1);  // 1..21
    const MedianInterval interval = median_interval(values);
    CHECK(interval.median == 11);
    CHECK(interval.low == 6);
    CHECK(interval.high == 16);
    CHECK(median({4, 1, 3, 2}) == 2.5);
    CHECK(median_deviation({1, 2, 4, 8, 16}) == 3);
}

TEST_CASE("ratio_interval is of the pairs: what slows both sides alike changes nothing") {
    std::vector<double> a, b;
    for (int i = 0; i < 15; ++i) {
        const double mood = 1 + 0.25 * i;
        a.push_back(3 * mood);
        b.push_back(2 * mood);
    }
    const MedianInterval same = ratio_interval(a, b);
    CHECK(same.median == doctest::Approx(1.5));
    CHECK(same.high - same.low < 1e-12);

    // A median of ratios is not a ratio of medians.
    const MedianInterval odd = ratio_interval(std::vector<double>{1, 2, 9}, std::vector<double>{1, 1, 1.5});
    CHECK(odd.median == 2);

    CHECK_THROWS_AS(ratio_interval(a, std::vector<double>{1}), UsageError);
    CHECK_THROWS_AS(ratio_interval(std::vector<double>{1, 0}, std::vector<double>{1, 1}), UsageError);
    CHECK_THROWS_AS(ratio_interval(std::vector<double>{1, NAN}, std::vector<double>{1, 1}), UsageError);
    CHECK_THROWS_AS(ratio_interval(std::vector<double>{}, std::vector<double>{}), UsageError);
}

TEST_CASE("verdict: an aim is met or missed only when the whole interval says so") {
    const MedianInterval interval{10, 9, 11, 0.97};
    CHECK(verdict(interval, 9) == AimVerdict::met);
    CHECK(verdict(interval, 9.5) == AimVerdict::undecided);
    CHECK(verdict(interval, 11) == AimVerdict::undecided);
    CHECK(verdict(interval, 11.5) == AimVerdict::missed);
}

TEST_CASE("fitted_power_law: exact laws give their exponent, and noise its standard error") {
    for (const double exponent : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
        CAPTURE(exponent);
        std::vector<double> x, y;
        for (const double value : {1.0, 2.0, 10.0, 500.0, 1e6}) {
            x.push_back(value);
            y.push_back(0.25 * std::pow(value, exponent));
        }
        const PowerLaw law = fitted_power_law(x, y);
        CHECK(law.exponent == doctest::Approx(exponent).epsilon(1e-12));
        CHECK(law.factor == doctest::Approx(0.25).epsilon(1e-12));
        CHECK(law.exponent_error < 1e-10);
    }
    CHECK_THROWS_AS(fitted_power_law(std::vector<double>{1, 2}, std::vector<double>{0, 1}), UsageError);
    CHECK_THROWS_AS(fitted_power_law(std::vector<double>{3, 3}, std::vector<double>{1, 2}), UsageError);
}

TEST_CASE("fitted_line: slope, intercept and standard error of a worked example") {
    // Residuals -0.1, 0.2, -0.1 around 1 + 2 x; their squares sum to 0.06, one degree of freedom, Sxx = 2.
    const Line line = fitted_line(std::vector<double>{0, 1, 2}, std::vector<double>{0.9, 3.2, 4.9});
    CHECK(line.slope == doctest::Approx(2));
    CHECK(line.intercept == doctest::Approx(1));
    CHECK(line.slope_error == doctest::Approx(std::sqrt(0.06 / 2)));
    CHECK(fitted_line(std::vector<double>{0, 1}, std::vector<double>{5, 7}).slope_error == 0);
    CHECK_THROWS_AS(fitted_line(std::vector<double>{1}, std::vector<double>{1}), UsageError);
}
