#include "chapters/study/error_points.h"

#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/noise.h"

using namespace crevice;

namespace {

ErrorPoint point(const char* method, const char* setting, double time_ms, double error) {
    return {method, setting, time_ms, error, error / 2, error * 2};
}

const TableValue& cell(const Table& table, std::size_t row, const std::string& column) {
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i] == column) return table.rows.at(row).at(i);
    FAIL("no column " << column);
    return table.rows.at(0).at(0);
}

}  // namespace

TEST_CASE("pareto_front: what nothing else beats in time and error") {
    const ErrorPoint points[] = {point("a", "slow and bad", 9, 9),     point("a", "best", 7, 1),
                                 point("b", "fastest", 1, 8),          point("b", "as fast, worse", 1, 8.5),
                                 point("a", "between", 3, 4),          point("b", "as good, slower", 8, 1),
                                 point("b", "beaten by between", 4, 5)};
    CHECK(pareto_front(points) == std::vector<std::size_t>{2, 4, 1});
    CHECK(pareto_front({}).empty());
    const ErrorPoint twins[] = {point("a", "1", 2, 3), point("b", "1", 2, 3), point("b", "2", 1, 4)};
    CHECK(pareto_front(twins) == std::vector<std::size_t>{2, 0, 1});
}

TEST_CASE("pareto_front equals its definition on random points with many ties") {
    for (int seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        std::vector<ErrorPoint> points;
        for (int i = 0; i < 40; ++i) {
            const double time = 1 + static_cast<int>(8 * noise(1, i, seed)),
                         error = static_cast<int>(8 * noise(2, i, seed));
            points.push_back(point("m", "s", time, error));
        }
        std::vector<bool> in_front(points.size(), false);
        for (const std::size_t i : pareto_front(points)) in_front[i] = true;
        for (std::size_t i = 0; i < points.size(); ++i) {
            bool beaten = false;
            for (const ErrorPoint& other : points) {
                beaten = beaten || (other.time_ms <= points[i].time_ms && other.error <= points[i].error &&
                                    (other.time_ms < points[i].time_ms || other.error < points[i].error));
            }
            CAPTURE(i);
            CHECK(in_front[i] == !beaten);
        }
    }
}

TEST_CASE("equal_time_table: the slowest setting within each budget; ties go to the larger error") {
    const ErrorPoint points[] = {point("rays", "1", 4, 0.3),      point("rays", "4", 19, 0.1),
                                 point("rays", "4 too", 19, 0.2), point("rays", "16", 81, 0.05),
                                 point("luna", "14", 5, 0.15),    point("slow", "1", 1000, 0.01)};
    const Table table = equal_time_table(points, kBudgets_ms);
    REQUIRE(table.rows.size() == 3);
    CHECK(cell(table, 0, "method").text == "rays");
    CHECK(cell(table, 0, "setting_5_ms").text == "1");
    CHECK(cell(table, 0, "setting_20_ms").text == "4 too");
    CHECK(cell(table, 0, "error_20_ms").number == 0.2);
    CHECK(cell(table, 0, "setting_80_ms").text == "4 too");
    CHECK(cell(table, 0, "time_80_ms").number == 19);
    CHECK(cell(table, 1, "setting_5_ms").text == "14");  // exactly 5 ms keeps the budget
    CHECK(cell(table, 2, "setting_80_ms").kind == TableValue::Kind::nothing);
    CHECK(cell(table, 2, "error_80_ms").kind == TableValue::Kind::nothing);
    for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
}

TEST_CASE("equal_error_table: the fastest setting that is no worse, or not reached") {
    const ErrorPoint points[] = {point("rays", "64", 300, 0.02), point("rays", "16", 80, 0.05),
                                 point("rays", "20", 100, 0.04), point("luna", "14", 5, 0.15)};
    const Table table = equal_error_table(points, kErrorLevels);
    CHECK(cell(table, 0, "setting_at_0.05").text == "16");
    CHECK(cell(table, 0, "time_at_0.05").number == 80);
    CHECK(cell(table, 0, "setting_at_0.02").text == "64");
    CHECK(cell(table, 1, "setting_at_0.05").text == "not reached");
    CHECK(cell(table, 1, "time_at_0.05").kind == TableValue::Kind::nothing);
    for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
}

TEST_CASE("error_curves: a series a method by time, with its spread, and the front last") {
    const ErrorPoint points[] = {point("rays", "4", 20, 0.1), point("luna", "14", 5, 0.15),
                                 point("rays", "1", 4, 0.3)};
    const std::vector<PlotCurve> curves = error_curves(points);
    REQUIRE(curves.size() == 3);
    CHECK(curves[0].name == "rays");
    CHECK(curves[0].x == std::vector<double>{4, 20});
    CHECK(curves[0].y == std::vector<double>{0.3, 0.1});
    CHECK(curves[0].y_low == std::vector<double>{0.15, 0.05});
    CHECK(curves[0].y_high == std::vector<double>{0.6, 0.2});
    CHECK(curves[0].x_low == curves[0].x);  // times without a bar
    CHECK(curves[0].x_high == curves[0].x);
    CHECK(curves[1].name == "luna");
    CHECK(curves[2].style == PlotStyle::front);
    CHECK(curves[2].x == std::vector<double>{4, 5, 20});
}

TEST_CASE("error_curves: bars of times, and names of dots") {
    const ErrorPoint points[] = {{"rays", "1", 4, 0.3, 0.2, 0.4, 3, 6, "v1-0"}};
    const std::vector<PlotCurve> curves = error_curves(points);
    CHECK(curves[0].x_low == std::vector<double>{3});
    CHECK(curves[0].x_high == std::vector<double>{6});
    CHECK(curves[0].points == std::vector<std::string>{"v1-0"});
}

TEST_CASE("error points that failed are refused by name") {
    for (const double bad :
         {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        CAPTURE(bad);
        const ErrorPoint bad_error[] = {{"luna", "14", 5, bad, 0.1, 0.2}},
                         bad_time[] = {{"luna", "14", bad, 0.1, 0.1, 0.2}},
                         bad_spread[] = {{"luna", "14", 5, 0.1, 0.1, bad}};
        CHECK_THROWS_AS(pareto_front(bad_error), UsageError);
        CHECK_THROWS_AS(equal_time_table(bad_time, kBudgets_ms), UsageError);
        CHECK_THROWS_AS(equal_error_table(bad_error, kErrorLevels), UsageError);
        CHECK_THROWS_AS(error_curves(bad_spread), UsageError);
    }
    const ErrorPoint no_time[] = {{"luna", "14", 0, 0.1, 0.1, 0.2}};
    CHECK_THROWS_WITH_AS(pareto_front(no_time),
                         "point \"luna\", \"14\" has no usable numbers (time 0 ms, error 0.1, from 0.1 to "
                         "0.2); leave out what failed",
                         UsageError);
}
