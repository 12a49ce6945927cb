#include "chapters/notebook/plot_picture.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

constexpr Size kSize = {142, 98};  // leaves 100 x 76 pixels, x from 34, y from 8
constexpr double kNanValue = std::numeric_limits<double>::quiet_NaN();

glm::ivec3 pixel(const Picture& picture, int x, int y) {
    const auto at = static_cast<std::size_t>(3 * (y * picture.size.width + x));
    return {picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]};
}

Picture plot(const PlotFrame& frame, const PlotSeries& series) {
    return plot_picture(kSize, frame, std::span(&series, 1));
}

constexpr glm::vec3 kRed{1, 0, 0};
constexpr glm::ivec3 kRedPixel{255, 0, 0};

int count_red(const Picture& picture) {
    int count = 0;
    for (int y = 0; y < picture.size.height; ++y) {
        for (int x = 0; x < picture.size.width; ++x) count += pixel(picture, x, y) == kRedPixel;
    }
    return count;
}

}  // namespace

TEST_CASE("plot_picture: values stand where the frame says, linear and logarithmic") {
    const Picture linear = plot({0, 10, -1, 1}, {{5.05}, {0.0}, PlotMark::dots, kRed});
    CHECK(linear.channels == 3);
    CHECK(pixel(linear, 34 + 50, 8 + 38) == kRedPixel);
    CHECK(count_red(linear) >= 9);
    CHECK(count_red(linear) <= 25);
    // A hundred is two thirds of the way from 1 to 1000, a tenth halfway from .01 to 1.
    const Picture log = plot({1, 1000, 0.01, 1, true}, {{100}, {0.1}, PlotMark::dots, kRed});
    CHECK(pixel(log, 34 + 66, 8 + 37) == kRedPixel);
    CHECK(pixel(log, 34 + 50, 8 + 37) != kRedPixel);
}

TEST_CASE("plot_picture: a line joins its points and breaks where there is no value") {
    const PlotFrame frame = {0, 1, 0, 1};
    const PlotSeries whole = {{0, 0.5, 1}, {0.3, 0.3, 0.3}, PlotMark::line, kRed};
    const PlotSeries broken = {{0, 0.4, 0.5, 0.6, 1}, {0.3, 0.3, kNanValue, 0.3, 0.3}, PlotMark::line, kRed};
    const int y = 8 + 53;  // .3 is 53.2 pixels from the top
    for (const int column : {4, 30, 50, 70, 95}) {
        CAPTURE(column);
        CHECK(pixel(plot(frame, whole), 34 + column, y) == kRedPixel);
        CHECK((pixel(plot(frame, broken), 34 + column, y) == kRedPixel) == (column != 50));
    }
}

TEST_CASE("plot_picture: what lies outside is cut off, however far, and leaves the margins alone") {
    const PlotFrame frame = {0, 1, 0, 1};
    const Picture empty = plot_picture(kSize, frame, {});
    for (const double far : {1.5, 1e30, 1e300, std::numeric_limits<double>::infinity()}) {
        CAPTURE(far);
        const Picture picture =
            plot(frame, {{-far, far, 0.5, 0.5}, {0.5, 0.5, -far, far}, PlotMark::line, kRed});
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                const bool inside = x >= 34 && x < 134 && y >= 8 && y < 84;
                if (!inside && pixel(picture, x, y) != pixel(empty, x, y))
                    FAIL_CHECK("pixel " << x << " " << y);
            }
        }
    }
    const PlotFrame log = {1, 10, 1, 10, true};
    CHECK(count_red(plot(log, {{0, -1, 5}, {5, 5, 0}, PlotMark::dots, kRed})) == 0);
    const PlotSeries line = {{2, 5}, {5, 5}, PlotMark::line, kRed},
                     after_nothing = {{-3, 2, 5}, {5, 5, 5}, PlotMark::line, kRed};
    CHECK(plot(log, after_nothing).pixels == plot(log, line).pixels);
}

TEST_CASE("plot_picture: the grid is labelled") {
    const Picture picture = plot_picture(kSize, {0, 1, 0, 1}, {});
    // "0" below the left end of the x axis: its upper left pixel is set, its middle is not.
    int dark = 0;
    for (int y = 84; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) dark += pixel(picture, x, y).x < 100;
    }
    CHECK(dark > 40);
    CHECK(picture.mapping == "plot, linear: x 0 to 1, y 0 to 1");
    CHECK(pixel(picture, 34 + 50, 20) == pixel(picture, 34 + 50, 70));  // a grid line
    CHECK(pixel(picture, 34 + 50, 20) != pixel(picture, 34 + 52, 20));
}

TEST_CASE("plot_picture: frames, sizes and series that cannot be drawn are named") {
    const PlotFrame frame = {0, 1, 0, 1};
    CHECK_THROWS_AS(plot_picture({63, 48}, frame, {}), UsageError);
    CHECK_THROWS_AS(plot({1, 1, 0, 1}, {}), UsageError);
    CHECK_THROWS_AS(plot({0, 1, 0, kNanValue}, {}), UsageError);
    CHECK_THROWS_AS(plot({0, 1, 0.1, 1, true}, {}), UsageError);
    CHECK_THROWS_AS(plot(frame, {{1, 2}, {1}}), UsageError);
}
