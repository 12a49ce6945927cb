#include "chapters/notebook/plot.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/well_formed.h"

using namespace crevice;

namespace {

bool shows(const std::string& svg, const std::string& part) { return svg.find(part) != std::string::npos; }

// Two decades each way: 250 units across and 152.5 upright to a decade.
Plot two_decades(PlotCurve curve) {
    return {"t", {"x", true, 1, 100}, {"y", true, 0.01, 1}, {std::move(curve)}};
}

}  // namespace

TEST_CASE("plot_svg: error bars both ways, from low to high") {
    PlotCurve curve{"c", {10}, {0.1}, {0.01}, {1}};
    curve.x_low = {1};
    curve.x_high = {100};
    const std::string svg = plot_svg(two_decades(curve));
    CHECK(xml_fault(svg) == "");
    CHECK(shows(svg, "<circle cx=\"320.0\" cy=\"192.5\" r=\"3.0\""));
    CHECK(shows(svg, "<line x1=\"320.0\" y1=\"345.0\" x2=\"320.0\" y2=\"40.0\""));
    CHECK(shows(svg, "<line x1=\"70.0\" y1=\"192.5\" x2=\"570.0\" y2=\"192.5\" stroke=\"var(--series-0"));
    // Axes that were not asked for hold the bars, too.
    const std::string free = plot_svg({"t", {"x", true}, {"y", true}, {curve}});
    CHECK(shows(free, "data-x=\"log 0 2 70 570\" data-y=\"log -2 0 345 40\""));
}

TEST_CASE("plot_svg: a line through some of the points, all of which have a dot and a name in the page") {
    PlotCurve curve{"a<b", {1, 10, 100}, {0.01, 1, 0.1}};
    curve.line_through = {0, 2};
    curve.points = {"v1-0", "v1-1", "v1-2"};
    const std::string svg = plot_svg(two_decades(curve));
    CHECK(xml_fault(svg) == "");
    CHECK(shows(svg, "points=\"70.0,345.0 570.0,192.5 \""));
    CHECK(shows(svg,
                "<circle cx=\"320.0\" cy=\"40.0\" r=\"3.0\" fill=\"var(--series-0, #0072b2)\" "
                "data-point=\"v1-1\"/>"));
    CHECK(shows(svg, "<g class=\"curve\" data-name=\"a&lt;b\">"));
}

TEST_CASE("plot_svg: a level line, and a bar as long as a ratio") {
    Plot plot = two_decades({"c", {10}, {0.1}});
    plot.lines = {{0.1, "noise", true}};
    plot.spans = {{0.8, 0.8 * std::pow(10, 0.1), "A/A"}};
    const std::string svg = plot_svg(plot);
    CHECK(xml_fault(svg) == "");
    CHECK(shows(svg, "points=\"70.0,192.5 570.0,192.5 \""));
    CHECK(shows(svg, ">noise</text>"));
    CHECK(shows(svg, "<g class=\"spans\">\n<line x1=\"82.0\" y1=\"333.0\" x2=\"107.0\" y2=\"333.0\""));
    CHECK(shows(svg, ">A/A</text>"));
    plot.spans = {{0.001, 1000, "A/A"}};  // no further than the axis
    CHECK(shows(plot_svg(plot), "<line x1=\"82.0\" y1=\"333.0\" x2=\"570.0\" y2=\"333.0\""));
}

TEST_CASE("snug_axis: to 1, 2 or 5 times a power of ten around the values") {
    const PlotAxis axis = snug_axis("ms", {0.3, 7, 0, -1, INFINITY, NAN});
    CHECK(axis.logarithmic);
    CHECK(axis.low == doctest::Approx(0.2));
    CHECK(axis.high == doctest::Approx(10));
    CHECK(snug_axis("ms", {1}).low == doctest::Approx(0.5));
    CHECK(snug_axis("ms", {1}).high == doctest::Approx(2));
    CHECK(snug_axis("ms", {99}).high == doctest::Approx(200));
    CHECK(std::isnan(snug_axis("ms", {}).low));
    CHECK(std::isnan(snug_axis("ms", {0}).high));
}
