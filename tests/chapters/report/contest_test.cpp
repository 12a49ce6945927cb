#include "chapters/report/contest.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/synthetic_sweep.h"

using namespace crevice;

namespace {

// Of four methods, the first and third with two settings.
SweepResults four_methods() {
    SweepResults results;
    const auto add = [&](const char* method, int samples, double rmse, double ms) {
        results.errors.push_back(synthetic_error(kSmallView, with_samples(method, samples), rmse, 0.001));
        results.times.push_back(synthetic_time(kSmallView, with_samples(method, samples), 1, ms));
    };
    add("xjun", 4, 0.09, 1);
    add("xjun", 8, 0.08, 2);
    add("gtao", 8, 0.0415, 11);
    add("vbao", 4, 0.06, 5);
    add("vbao", 8, 0.04, 10);
    add("hbao", 8, 0.05, 30);
    return results;
}

std::vector<std::string> methods_of(const Contest& contest) {
    std::vector<std::string> methods;
    for (const Contestant& one : contest.ranking) methods.push_back(one.method());
    return methods;
}

}  // namespace

TEST_CASE("least_error_within: each method's best within the budget, and who ties with the first") {
    const SweepResults results = four_methods();
    const std::vector<ViewFigures> views = view_figures(results);
    const std::vector<Contestant> all = contestants(views[0], 1);
    CHECK(all.size() == 6);
    const Contest late = least_error_within(all, 80);
    CHECK(methods_of(late) == std::vector<std::string>{"vbao", "gtao", "hbao", "xjun"});
    CHECK(late.ties == 2);
    CHECK(late.ranking[3].rmse() == doctest::Approx(0.08));
    const Contest early = least_error_within(all, 5);  // exactly 5 ms keep the budget
    CHECK(methods_of(early) == std::vector<std::string>{"vbao", "xjun"});
    CHECK(early.won());
    CHECK(least_error_within(all, 0.5).ranking.empty());
    CHECK(contestants(views[0], 2).empty());
    CHECK(contestants(views[0], 0).size() == 6);
}

TEST_CASE("least_time_to: the fastest setting of each method that is no worse, and who ties with the first") {
    const SweepResults results = four_methods();
    const std::vector<ViewFigures> views = view_figures(results);
    const std::vector<Contestant> all = contestants(views[0], 1);
    const Contest still = least_time_to(all, 0.05, BarFigure{1, 0.99, 1.01});
    CHECK(methods_of(still) == std::vector<std::string>{"vbao", "gtao", "hbao"});
    CHECK(still.won());
    CHECK(still.ranking[0].ms() == 10);
    CHECK(least_time_to(all, 0.05, BarFigure{1, 0.9, 1.02}).ties == 2);  // 11 / 10 is within 1 / 0.9
    CHECK(least_time_to(all, 0.05, std::nullopt).won());
    CHECK(least_time_to(all, 0.06, std::nullopt).ranking[0].ms() == 5);
    CHECK(least_time_to(all, 0.01, std::nullopt).ranking.empty());
}

TEST_CASE("least_error: one that is less sure ties, even behind one that does not") {
    SweepResults results;
    results.errors = {synthetic_error(kSmallView, with_samples("gtao", 8), 0.040, 0.0005),
                      synthetic_error(kSmallView, with_samples("vbao", 8), 0.043, 0.0005),
                      synthetic_error(kSmallView, with_samples("hbao", 8), 0.044, 0.005),
                      synthetic_error(kSmallView, with_samples("xjun", 8), 0.2, INFINITY)};
    const std::vector<ViewFigures> views = view_figures(results);
    const Contest contest = least_error(contestants(views[0], 0));
    CHECK(methods_of(contest) == std::vector<std::string>{"gtao", "hbao", "xjun", "vbao"});
    CHECK(contest.ties == 3);
}
