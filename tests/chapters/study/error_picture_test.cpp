// The pictures of errors: stacked bars, and what log_log_plot draws for errors over time.
#include "chapters/study/error_picture.h"

#include <cstdlib>
#include <limits>

#include <doctest/doctest.h>

#include "chapters/notebook/plot.h"
#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

int count_of(const std::string& text, const std::string& piece) {
    int count = 0;
    for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
    return count;
}

struct Box {
    double top = 0, height = 0;

    double bottom() const { return top + height; }
};

// The box whose hint is `hint`.
Box box_of(const std::string& svg, const std::string& hint) {
    const std::size_t end = svg.find("><title>" + hint + "</title>");
    CAPTURE(hint);
    REQUIRE(end != std::string::npos);
    const std::size_t begin = svg.rfind("<rect", end);
    const auto number_after = [&](const char* name) {
        const std::size_t at = svg.find(name, begin);
        return std::strtod(svg.c_str() + at + std::string(name).size(), nullptr);
    };
    return {number_after(" y=\""), number_after(" height=\"")};
}

bool near(double a, double b) { return a - b < 0.15 && b - a < 0.15; }  // both rounded to a tenth

}  // namespace

TEST_CASE("stacked_bars: parts stack up from the axis, negative ones down, the sum is marked") {
    const StackedBar bars[] = {
        {"luna", {{"depth", 0.02}, {"sampling", 0.04}, {"blur", -0.03}, {"storage", -0.01}}},
        {"rays", {{"sampling", 0.01}}}};
    const std::string svg = stacked_bars("Shares", "squared error", bars);
    const Box depth = box_of(svg, "depth: 0.02"), sampling = box_of(svg, "sampling: 0.04"),
              blur = box_of(svg, "blur: -0.03"), storage = box_of(svg, "storage: -0.01"),
              rays = box_of(svg, "sampling: 0.01"), sum = box_of(svg, "luna: 0.02");
    CHECK(near(sampling.bottom(), depth.top));
    CHECK(near(depth.bottom(), blur.top));
    CHECK(near(blur.bottom(), storage.top));
    CHECK(near(depth.bottom(), rays.bottom()));
    CHECK(near(sampling.height, 2 * depth.height));
    CHECK(near(blur.height, 3 * storage.height));
    CHECK(near(sum.top + 1, depth.top));  // .02 + .04 - .03 - .01 is as high as depth alone
    // Every part once in the legend, in the colour of its boxes.
    for (const char* const name : {">depth</text>", ">sampling</text>", ">blur</text>", ">storage</text>"}) {
        CAPTURE(name);
        CHECK(count_of(svg, name) == 1);
    }
    const auto colour_of = [&](const std::string& hint) {
        const std::size_t end = svg.find("><title>" + hint + "</title>");
        return svg.substr(svg.rfind("fill=", end), end - svg.rfind("fill=", end));
    };
    CHECK(colour_of("sampling: 0.04") == colour_of("sampling: 0.01"));
    CHECK(colour_of("sampling: 0.04") == colour_of("sampling"));
    CHECK(colour_of("sampling: 0.04") != colour_of("depth: 0.02"));
}

TEST_CASE("stacked_bars: everything is inside the picture, whatever the values") {
    for (const double scale : {1e-9, 1.0, 1e6}) {
        for (const double sign : {-1.0, 1.0}) {
            CAPTURE(scale);
            CAPTURE(sign);
            const StackedBar bars[] = {{"m", {{"a", sign * scale}, {"b", -0.3 * sign * scale}}}};
            const std::string svg = stacked_bars("t", "y", bars);
            for (std::size_t at = svg.find("<rect"); at != std::string::npos;
                 at = svg.find("<rect", at + 1)) {
                const double top = std::strtod(svg.c_str() + svg.find(" y=\"", at) + 4, nullptr),
                             height = std::strtod(svg.c_str() + svg.find(" height=\"", at) + 9, nullptr);
                CHECK(top >= 39);
                CHECK(top + height <= 366);
            }
        }
    }
}

TEST_CASE("stacked_bars: nothing, zeros and odd names") {
    CHECK(stacked_bars("t", "y", {}).find("nothing to draw") != std::string::npos);
    const StackedBar zero[] = {{"a < b", {{"c & d", 0.0}}}};
    const std::string svg = stacked_bars("<t>", "y", zero);
    CHECK(svg.find("a &lt; b") != std::string::npos);
    CHECK(svg.find("c &amp; d") != std::string::npos);
    CHECK(svg.find("&lt;t&gt;") != std::string::npos);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    const StackedBar broken[] = {{"luna", {{"blur", std::numeric_limits<double>::quiet_NaN()}}}};
    CHECK_THROWS_WITH_AS(stacked_bars("t", "y", broken),
                         "part \"blur\" of bar \"luna\" is not a finite number (nan); leave out what failed",
                         UsageError);
}

TEST_CASE("error_bar: the shares of the steps") {
    ErrorParts parts;
    parts.parts.resize(2);
    parts.parts[0].step = "definition";
    parts.parts[0].share = 0.5;
    parts.parts[0].mse = 9;
    parts.parts[1].step = "sampling";
    parts.parts[1].share = -0.25;
    const StackedBar bar = error_bar("luna", parts);
    CHECK(bar.name == "luna");
    CHECK(bar.parts == std::vector<std::pair<std::string, double>>{{"definition", 0.5}, {"sampling", -0.25}});
}

TEST_CASE("log_log_plot: a legend, bars of spread, and the front as rings") {
    PlotCurve rays{"rays", {1, 10}, {0.1, 0.01}, {0.05, 0}, {0.2, 0.02}}, dots{"dots", {2}, {0.5}},
        front{"front", {1, 10}, {0.1, 0.01}};
    dots.style = PlotStyle::dots;
    front.style = PlotStyle::front;
    const std::string svg = log_log_plot("t", "ms", "RMSE", {rays, dots, front});
    CHECK(count_of(svg, "<polyline") == 2);  // not of the dots
    CHECK(count_of(svg, "stroke-dasharray") == 1);
    CHECK(count_of(svg, "r=\"3.0\"") == 3);
    CHECK(count_of(svg, "r=\"6.0\"") == 2);
    for (const char* const name : {">rays</text>", ">dots</text>", ">front</text>"}) {
        CAPTURE(name);
        CHECK(count_of(svg, name) == 1);
    }
    // Two decades each way: 10 is at the right, .01 at the bottom; a bar down to 0 ends there.
    CHECK(svg.find("cx=\"570.0\" cy=\"345.0\" r=\"3.0\"") != std::string::npos);
    CHECK(svg.find("x1=\"570.0\" y1=\"345.0\" x2=\"570.0\" y2=\"299.1\"") != std::string::npos);
    CHECK(svg.find("nan") == std::string::npos);
    // What cannot be drawn has no place in the legend.
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(log_log_plot("t", "x", "y", {{"gone", {1, nan}, {nan, 1}}}).find("gone") == std::string::npos);
}
