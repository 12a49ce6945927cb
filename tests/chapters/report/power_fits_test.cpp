#include "chapters/report/power_fits.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/synthetic_sweep.h"

using namespace crevice;

namespace {

// Two sizes, two scenes, two numbers of threads and three of samples; the time is a power of each.
SweepResults powers() {
    SweepResults results;
    for (const char* const scene : {"columns", "cornell"}) {
        for (const int width : {320, 640, 1280}) {
            const SweepView view{
                scene, "", {width, width / 2}, scene[1] == 'o' && scene[2] == 'l' ? 1000 : 10};
            for (const int samples : {2, 4, 8}) {
                for (const int threads : {1, 2}) {
                    const double ms = 1e-5 * std::pow(width * width / 2, 1.1) * std::pow(samples, 0.9) *
                                      std::pow(threads, -0.8) * std::pow(view.triangles, 0.05);
                    results.times.push_back(synthetic_time(view, with_samples("xjun", samples), threads, ms));
                }
            }
        }
    }
    return results;
}

}  // namespace

TEST_CASE("convergence: an error that is a power of the samples has its exponent") {
    SweepResults results;
    for (const int samples : {1, 2, 4, 8, 16}) {
        results.errors.push_back(
            synthetic_error(kSmallView, with_samples("xjun", samples), 0.3 * std::pow(samples, -0.5), 0.001));
        results.errors.push_back(synthetic_error(kSmallView, with_samples("gtao", samples),
                                                 0.2 * std::pow(samples, -0.25) * (samples == 4 ? 1.1 : 1),
                                                 0.001));
    }
    const std::vector<ViewFigures> views = view_figures(results);
    REQUIRE(views.size() == 1);
    const std::vector<FittedSeries> series = convergence(views[0]);
    REQUIRE(series.size() == 2);
    CHECK(series[0].method == "xjun");
    CHECK(series[0].rest == "defaults");
    CHECK(series[0].x == std::vector<double>{1, 2, 4, 8, 16});
    REQUIRE(series[0].law);
    CHECK(series[0].law->exponent == doctest::Approx(-0.5));
    CHECK(series[0].law->factor == doctest::Approx(0.3));
    CHECK(series[0].law->exponent_error < 1e-9);
    REQUIRE(series[1].law);
    CHECK(std::fabs(series[1].law->exponent + 0.25) < 3 * series[1].law->exponent_error);
    CHECK(series[1].law->exponent_error > 0.001);
}

TEST_CASE(
    "convergence: settings that differ in anything else are other series, and the method's default counts") {
    SweepResults results;
    for (const char* const scale : {"0.5", "1"}) {
        for (const int samples : {4, 8})
            results.errors.push_back(synthetic_error(
                kSmallView, {"xjun", {{"samples", std::to_string(samples)}, {"ao_scale", scale}}}, 0.1,
                0.001));
    }
    // All 14 samples of the tutorial: nothing differs from the defaults.
    results.errors.push_back(synthetic_error(kSmallView, {"gtao", {}}, 0.1, 0.001));
    results.errors.push_back(synthetic_error(kSmallView, with_samples("gtao", 1), 0.2, 0.001));
    results.errors.push_back(synthetic_error(kSmallView, {"vbao", {}}, 0.1, 0.001));
    const std::vector<ViewFigures> views = view_figures(results);
    const std::vector<FittedSeries> series = convergence(views[0]);
    REQUIRE(series.size() == 3);
    CHECK(series[0].rest == "half size");
    CHECK(series[1].rest == "full size");
    CHECK(series[2].method == "gtao");
    CHECK(series[2].x.front() == 1);
    CHECK(series[2].x.back() > 1);
}

TEST_CASE("convergence: an error below the noise has no part in the law, and a lone point has none") {
    SweepResults results;
    for (const int samples : {1, 2, 4})
        results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", samples),
                                                 samples == 4 ? 0 : 0.1 / samples, 0.001));
    for (const int samples : {1, 2})
        results.errors.push_back(
            synthetic_error(kSmallView, with_samples("gtao", samples), samples == 2 ? 0 : 0.1, 0.001));
    const std::vector<ViewFigures> views = view_figures(results);
    const std::vector<FittedSeries> series = convergence(views[0]);
    REQUIRE(series.size() == 2);
    REQUIRE(series[0].law);
    CHECK(series[0].law->exponent == doctest::Approx(-1));
    CHECK(exponent_text(series[0].law) == "-1.000");  // of two points nothing is left to tell an error by
    CHECK_FALSE(series[1].law);
    CHECK(exponent_text(series[1].law) == "-");
}

TEST_CASE("cost_series: the exponent of each variable, all others held still") {
    const SweepResults results = powers();
    const std::vector<ViewFigures> views = view_figures(results);
    const double expected[] = {1.1, 0.05, 0.9, -0.8};
    for (std::size_t i = 0; i < std::size(kCostVariables); ++i) {
        CAPTURE(kCostVariables[i].name);
        const std::vector<FittedSeries> series = cost_series(views, kCostVariables[i]);
        REQUIRE(series.size() == 1);
        CHECK(series[0].method == "xjun");
        REQUIRE(series[0].law);
        CHECK(series[0].law->exponent == doctest::Approx(expected[i]));
    }
    CHECK(cost_series(views, kCostVariables[0])[0].x == std::vector<double>{51200, 204800, 819200});
    CHECK(cost_series(views, kCostVariables[0])[0].rest == "columns, 2 samples, 1 thread");
    CHECK(cost_series(views, kCostVariables[1])[0].rest == "320x160, 2 samples, 1 thread");
    CHECK(cost_series(views, kCostVariables[2])[0].rest == "columns, 320x160, defaults, 1 thread");
    CHECK(cost_series(views, kCostVariables[3])[0].rest == "columns, 320x160, 2 samples");
}

TEST_CASE("cost_series: nothing where the plan holds a variable still") {
    SweepResults results;
    results.times.push_back(synthetic_time(kSmallView, with_samples("xjun", 4), 1, 2));
    results.times.push_back(synthetic_time(kSmallView, with_samples("gtao", 8), 1, 2));
    const std::vector<ViewFigures> views = view_figures(results);
    for (const CostVariable& variable : kCostVariables) {
        CAPTURE(variable.name);
        CHECK(cost_series(views, variable).empty());
    }
}
