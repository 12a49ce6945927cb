#include "chapters/sweep/sweep_figures.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/synthetic_sweep.h"

using namespace crevice;

TEST_CASE("view_figures: seeds of a setting are one figure, their mean square with the margin of one") {
    SweepResults results;
    results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", 4), 0.03, 0.001, 1));
    results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", 4), 0.05, 0.001, 2));
    const std::vector<ViewFigures> views = view_figures(results);
    REQUIRE(views.size() == 1);
    REQUIRE(views[0].settings.size() == 1);
    const auto& errors = views[0].settings[0].errors;
    REQUIRE(errors);
    CHECK(errors->seeds == 2);
    CHECK(errors->rmse.value == doctest::Approx(std::sqrt((0.0009 + 0.0025) / 2)));
    CHECK(errors->rmse_margin() == doctest::Approx(0.00196));
    CHECK(errors->hard_rmse.value == doctest::Approx(2 * errors->rmse.value));
    CHECK(errors->bias.value == doctest::Approx(-0.01));
    CHECK(errors->bias.low == doctest::Approx(-0.0125));
    CHECK(errors->bias.high == doctest::Approx(-0.0075));
    double total = 0;
    for (const SweepErrorPart& part : errors->parts) total += part.share;
    CHECK(total == doctest::Approx(errors->rmse.value * errors->rmse.value));
}

TEST_CASE("view_figures: parts of the seeds that have them") {
    SweepResults results;
    results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", 4), 0.03, 0.001, 1));
    results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", 4), 0.05, 0.001, 2));
    results.errors.back().parts.clear();
    const std::vector<ViewFigures> views = view_figures(results);
    REQUIRE(views[0].settings[0].errors);
    const auto& parts = views[0].settings[0].errors->parts;
    REQUIRE(parts.size() == results.errors[0].parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        CHECK(parts[i].share == doctest::Approx(results.errors[0].parts[i].share));
}

TEST_CASE("view_figures: an image with NaN counts in no figure") {
    SweepResults results;
    results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", 4), 0.03, 0.001, 1));
    results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", 4), 9, 0.001, 2));
    results.errors.back().nan_or_inf = 1;
    results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", 8), 9, 0.001, 1));
    results.errors.back().nan_or_inf = 1;
    const std::vector<ViewFigures> views = view_figures(results);
    REQUIRE(views[0].settings.size() == 2);
    REQUIRE(views[0].settings[0].errors);
    CHECK(views[0].settings[0].errors->rmse.value == doctest::Approx(0.03));
    CHECK(views[0].settings[0].errors->seeds == 1);
    CHECK(views[0].settings[0].failed_seeds() == 1);
    CHECK_FALSE(views[0].settings[1].errors);
}

TEST_CASE("view_figures: identical images have no error, and a known bias is the bias") {
    SweepResults results;
    results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", 4), 0, 0));
    results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", 8), 0.1, 0));
    results.errors.back().soft.bias = 0.1;
    const std::vector<ViewFigures> views = view_figures(results);
    CHECK(views[0].settings[0].errors->rmse.value == 0);
    CHECK(views[0].settings[0].errors->bias.value == 0);
    CHECK(views[0].settings[1].errors->bias.value == 0.1);
}

TEST_CASE(
    "view_figures: times by threads, of AO and blur together, and points named by the row of the table") {
    SweepResults results;
    results.errors.push_back(synthetic_error(kSmallView, with_samples("gtao", 2), 0.03, 0.001));
    for (const int threads : {2, 1}) {
        results.times.push_back(synthetic_time(kSmallView, with_samples("xjun", 4), threads, 6.0 / threads));
        results.times.push_back(synthetic_time(kSmallView, with_samples("xjun", 8), threads, 9.0 / threads));
    }
    const std::vector<ViewFigures> views = view_figures(results);
    REQUIRE(views.size() == 1);
    CHECK(views[0].threads == std::vector<int>{1, 2});
    REQUIRE(views[0].settings.size() == 3);
    CHECK(views[0].settings[0].point == "v1-0");
    const SettingFigures& second = views[0].settings[1];
    REQUIRE(second.times.size() == 2);
    CHECK(second.times[0].threads == 1);
    CHECK(second.times[0].ms.value == 6);
    CHECK(second.times[0].point == "v1-1");
    CHECK(second.times[1].point == "v1-2");
    CHECK(views[0].settings[2].point == "v1-3");
    CHECK(second.time(3) == nullptr);
}

TEST_CASE("same_again: the widest of all that were run twice, and always holding 1") {
    SweepResults results;
    results.times.push_back(synthetic_time(kSmallView, with_samples("xjun", 4), 1, 6));
    results.times.push_back(synthetic_time(kSmallView, with_samples("gtao", 4), 1, 6));
    CHECK_FALSE(view_figures(results)[0].same_again(1));
    results.times[0].same_again = MedianInterval{1.02, 1.01, 1.03, 0.96};
    const auto one = view_figures(results)[0].same_again(1);
    REQUIRE(one);
    CHECK(one->low == 1);
    CHECK(one->high == 1.03);
    results.times[1].same_again = MedianInterval{0.99, 0.97, 1.01, 0.96};
    CHECK(view_figures(results)[0].same_again(1)->low == 0.97);
    CHECK(view_figures(results)[0].same_again(1)->high == 1.03);
    CHECK_FALSE(view_figures(results)[0].same_again(2));
}

TEST_CASE(
    "view_figures: squares of errors are averaged before the root, for the floor as well, and may cancel "
    "near the noise") {
    SweepResults results = synthetic_sweep();
    results.errors.resize(2);
    results.errors[1].setting = results.errors[0].setting;
    results.errors[0].soft.mse = 0.0004;
    results.errors[1].soft.mse = -0.0002;
    results.errors[0].limit_mse = 0.0018;
    results.errors[1].limit_mse = std::nullopt;
    const SettingErrors errors = *view_figures(results)[0].settings[0].errors;
    CHECK(errors.rmse.value == doctest::Approx(0.01));
    CHECK(*errors.limit_rmse == doctest::Approx(std::sqrt(0.0018)));
    results.errors[0].soft.mse = 0.0001;
    CHECK(view_figures(results)[0].settings[0].errors->rmse.value == 0);
}

TEST_CASE("parameter_value: as set, or the method's default") {
    CHECK(parameter_value({"xjun", {{"samples", "3"}}}, "samples") == 3.0);
    CHECK(parameter_value({"xjun", {}}, "samples") == 14.0);
    CHECK_FALSE(parameter_value({"xjun", {}}, "no such"));
    CHECK_FALSE(parameter_value({"a method of a later version", {}}, "samples"));
    CHECK_FALSE(parameter_value({"xjun", {{"samples", "many"}}}, "samples"));
}
