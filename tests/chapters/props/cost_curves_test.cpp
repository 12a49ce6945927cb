#include "chapters/props/cost_curves.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("cost curves: on the Pareto front stands what nothing beats in cost and in error") {
    PlotCurve a{"a", {}, {}}, b{"b", {}, {}};
    a.x = {1, 2, 4}, a.y = {3, 2, 5};
    b.x = {1, 3}, b.y = {4, 1};
    const PlotCurve front = front_of({a, b});
    CHECK(front.x == std::vector<double>{1, 2, 3});
    CHECK(front.y == std::vector<double>{3, 2, 1});
}

TEST_CASE("cost curves: a plan of half the size, but not less than 160 by 90") {
    CHECK(cost_plan({640, 360}, 2).size == Size{320, 180});
    CHECK(cost_plan({160, 90}, 2).size == Size{160, 90});
}
