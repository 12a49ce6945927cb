#include "chapters/notebook/plot.h"

#include <algorithm>
#include <cmath>

#include "chapters/notebook/svg.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr double kWidth = 800, kHeight = 420;  // of the picture, SVG units
constexpr double kLeft = 70, kRight = 210, kTop = 40, kBottom = 55;
constexpr const char* kGrid = "#ddd";
constexpr const char* kFrontColour = "#555";

bool drawable(double value) { return value > 0 && std::isfinite(value); }

// One axis: decades from `low` to `high` laid out between two SVG coordinates.
struct Axis {
    int low = 0, high = 1;  // powers of ten
    double from = 0, to = 0;

    double at(double value) const {
        return drawable(value) ? from + (to - from) * (std::log10(value) - low) / (high - low) : from;
    }
};

// 0.01, 0.02, 1, 100, then 1e5, 2e5.
std::string tick_label(int factor, int exponent) {
    if (exponent > 4 || exponent < -3) return std::to_string(factor) + "e" + std::to_string(exponent);
    return significant_text(factor * std::pow(10.0, exponent), 6);
}

// The decades that hold all of these values that can be drawn.
Axis axis_over(const std::vector<double>& values, double from, double to) {
    double low = INFINITY, high = 0;
    for (const double value : values) {
        if (!drawable(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (high == 0) return {0, 1, from, to};
    const int first = static_cast<int>(std::floor(std::log10(low))),
              last = static_cast<int>(std::ceil(std::log10(high)));
    return {first, std::max(last, first + 1), from, to};
}

struct Axes {
    Axis x, y;

    SvgPoint at(double value_x, double value_y) const { return {x.at(value_x), y.at(value_y)}; }
};

Axes axes_of(const std::vector<PlotCurve>& curves) {
    std::vector<double> x, y;
    for (const PlotCurve& curve : curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (!drawable(curve.x[i]) || !drawable(curve.y[i])) continue;
            x.push_back(curve.x[i]);
            y.push_back(curve.y[i]);
            if (!curve.y_low.empty()) y.insert(y.end(), {curve.y_low[i], curve.y_high[i]});
        }
    }
    return {axis_over(x, kLeft, kWidth - kRight), axis_over(y, kHeight - kBottom, kTop)};
}

struct Tick {
    double at;  // SVG coordinate
    std::string label;
};

// The decades; twice and five times each where there are no more than two.
std::vector<Tick> ticks_of(const Axis& axis) {
    std::vector<Tick> ticks;
    for (int e = axis.low; e <= axis.high; ++e) {
        for (const int factor : {1, 2, 5}) {
            if (factor > 1 && (axis.high - axis.low > 2 || e == axis.high)) continue;
            ticks.push_back({axis.at(factor * std::pow(10.0, e)), tick_label(factor, e)});
        }
    }
    return ticks;
}

std::string grid(const Axis& x, const Axis& y) {
    std::string svg;
    for (const Tick& tick : ticks_of(x)) {
        svg += svg_line({tick.at, y.from}, {tick.at, y.to}, kGrid) +
               svg_text({tick.at, y.from + 18}, tick.label, TextAnchor::middle);
    }
    for (const Tick& tick : ticks_of(y)) {
        svg += svg_line({x.from, tick.at}, {x.to, tick.at}, kGrid) +
               svg_text({x.from - 6, tick.at + 4}, tick.label, TextAnchor::end);
    }
    return svg;
}

// Empty when none of its points can be drawn.
std::string drawn_curve(const PlotCurve& curve, const Axes& axes, std::string_view colour) {
    std::vector<SvgPoint> points;
    std::string marks;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!drawable(curve.x[i]) || !drawable(curve.y[i])) continue;
        points.push_back(axes.at(curve.x[i], curve.y[i]));
        const SvgPoint at = points.back();
        marks += curve.style == PlotStyle::front ? svg_ring(at, 6, colour) : svg_dot(at, 3, colour);
        if (curve.y_low.empty()) continue;
        marks += svg_line({at.x, axes.y.at(curve.y_low[i])}, {at.x, axes.y.at(curve.y_high[i])}, colour);
    }
    if (points.empty() || curve.style == PlotStyle::dots) return marks;
    const char* const dashes = curve.style == PlotStyle::front ? " stroke-dasharray=\"2 4\"" : "";
    return svg_polyline(points, colour, dashes) + marks;
}

}  // namespace

std::string log_log_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                         const std::vector<PlotCurve>& curves) {
    const Axes axes = axes_of(curves);
    std::string drawn;
    std::vector<LegendEntry> legend;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const bool front = curves[i].style == PlotStyle::front;
        const std::string_view colour = front ? kFrontColour : series_colour(i);
        const std::string curve = drawn_curve(curves[i], axes, colour);
        if (curve.empty()) continue;
        drawn += curve;
        legend.push_back({curves[i].name, colour, front});
    }
    if (drawn.empty()) drawn = svg_text({kWidth / 2, kHeight / 2}, "nothing to draw", TextAnchor::middle);
    const SvgPoint middle = {(kLeft + kWidth - kRight) / 2, (kTop + kHeight - kBottom) / 2};
    return svg_picture(title, kWidth, kHeight,
                       grid(axes.x, axes.y) + drawn + svg_legend({kWidth - kRight + 12, kTop + 8}, legend) +
                           svg_text({middle.x, kHeight - 12}, x_label, TextAnchor::middle) +
                           svg_upward_text({16, middle.y}, y_label));
}

}  // namespace crevice
