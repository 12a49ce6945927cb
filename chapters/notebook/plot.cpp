#include "chapters/notebook/plot.h"

#include <algorithm>
#include <cmath>

#include "chapters/notebook/svg.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr double kWidth = 760, kHeight = 400;  // of the picture, SVG units
constexpr double kLeft = 70, kRight = 190, kTop = 40, kBottom = 55;
constexpr double kLabelWidth = 110;  // room that the name of a dashed line may need, SVG units
constexpr double kLinearTicks = 6;   // about so many on a linear axis

// One axis laid out between two SVG coordinates. A logarithmic one counts in decades.
struct Axis {
    bool logarithmic = false;
    double low = 0, high = 1;  // values, or their powers of ten
    double from = 0, to = 0;

    bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
    double at(double value) const {
        if (!shows(value)) return from;
        return from + (to - from) * ((logarithmic ? std::log10(value) : value) - low) / (high - low);
    }
};

// 1, 2 or 5 times a power of ten: the step of about so many ticks over `extent`.
double tick_step(double extent) {
    const double power = std::pow(10.0, std::floor(std::log10(extent / kLinearTicks)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power * kLinearTicks >= extent) return factor * power;
    }
    return 10 * power;
}

// What holds all these values, or what the plot asks for.
Axis axis_over(const PlotAxis& asked, const std::vector<double>& values, double from, double to) {
    Axis axis{asked.logarithmic, 0, 1, from, to};
    double low = INFINITY, high = -INFINITY;
    for (const double value : values) {
        if (!axis.shows(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (!std::isnan(asked.low)) low = asked.low;
    if (!std::isnan(asked.high)) high = asked.high;
    if (!(low <= high)) return axis;
    if (axis.logarithmic) {
        axis.low = std::isnan(asked.low) ? std::floor(std::log10(low)) : std::log10(low);
        axis.high = std::isnan(asked.high) ? std::ceil(std::log10(high)) : std::log10(high);
    } else {
        const double step = tick_step(high > low ? high - low : 1);
        axis.low = std::isnan(asked.low) ? std::floor(low / step) * step : low;
        axis.high = std::isnan(asked.high) ? std::ceil(high / step) * step : high;
    }
    if (axis.high <= axis.low) axis.high = axis.low + 1;
    return axis;
}

struct Axes {
    Axis x, y;

    bool shows(const PlotCurve& curve, std::size_t i) const {
        return x.shows(curve.x[i]) && y.shows(curve.y[i]);
    }
    SvgPoint at(double value_x, double value_y) const { return {x.at(value_x), y.at(value_y)}; }
};

Axes axes_of(const Plot& plot) {
    std::vector<double> x, y;
    const Axis any_x{plot.x.logarithmic}, any_y{plot.y.logarithmic};
    for (const PlotCurve& curve : plot.curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (!any_x.shows(curve.x[i]) || !any_y.shows(curve.y[i])) continue;
            x.push_back(curve.x[i]);
            y.push_back(curve.y[i]);
            if (!curve.y_low.empty()) y.insert(y.end(), {curve.y_low[i], curve.y_high[i]});
        }
    }
    return {axis_over(plot.x, x, kLeft, kWidth - kRight), axis_over(plot.y, y, kHeight - kBottom, kTop)};
}

struct Tick {
    double at;  // SVG coordinate
    std::string label;
};

// 0.01, 0.02, 1, 100, then 1e5, 2e5.
std::string decade_label(int factor, int exponent) {
    if (exponent > 4 || exponent < -3) return std::to_string(factor) + "e" + std::to_string(exponent);
    return significant_text(factor * std::pow(10.0, exponent), 6);
}

// The decades; twice and five times each where there are no more than two. Or steps of one width.
std::vector<Tick> ticks_of(const Axis& axis) {
    std::vector<Tick> ticks;
    constexpr double kRounding = 1e-9;
    if (axis.logarithmic) {
        for (int e = static_cast<int>(std::floor(axis.low)); e <= static_cast<int>(std::ceil(axis.high));
             ++e) {
            for (const int factor : {1, 2, 5}) {
                const double value = factor * std::pow(10.0, e), power = std::log10(value);
                if (power < axis.low - kRounding || power > axis.high + kRounding) continue;
                if (factor == 1 || axis.high - axis.low <= 2)
                    ticks.push_back({axis.at(value), decade_label(factor, e)});
            }
        }
        return ticks;
    }
    const double step = tick_step(axis.high - axis.low);
    for (double i = std::ceil(axis.low / step - kRounding); i * step <= axis.high + kRounding * step; ++i)
        ticks.push_back({axis.at(i * step), significant_text(i == 0 ? 0.0 : i * step, 6)});  // never -0
    return ticks;
}

std::string grid(const Axes& axes) {
    std::string svg;
    const Axis &x = axes.x, &y = axes.y;
    for (const Tick& tick : ticks_of(x)) {
        svg += svg_line({tick.at, y.from}, {tick.at, y.to}, kSvgGrid) +
               svg_text({tick.at, y.from + 18}, tick.label, TextAnchor::middle);
    }
    for (const Tick& tick : ticks_of(y)) {
        svg += svg_line({x.from, tick.at}, {x.to, tick.at}, kSvgGrid) +
               svg_text({x.from - 6, tick.at + 4}, tick.label, TextAnchor::end);
    }
    return svg;
}

// Empty when none of its points can be drawn.
std::string drawn_curve(const PlotCurve& curve, const Axes& axes, std::string_view colour) {
    std::vector<SvgPoint> points;
    std::string marks;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!axes.shows(curve, i)) continue;
        points.push_back(axes.at(curve.x[i], curve.y[i]));
        const SvgPoint at = points.back();
        if (curve.style == PlotStyle::front) marks += svg_ring(at, 6, colour);
        if (curve.style == PlotStyle::line || curve.style == PlotStyle::dots) marks += svg_dot(at, 3, colour);
        if (curve.y_low.empty()) continue;
        marks += svg_line({at.x, axes.y.at(curve.y_low[i])}, {at.x, axes.y.at(curve.y_high[i])}, colour);
    }
    if (points.empty() || curve.style == PlotStyle::dots) return marks;
    const char* const dashes = curve.style == PlotStyle::front ? " stroke-dasharray=\"2 4\"" : "";
    return svg_polyline(points, colour, dashes) + marks;
}

// Lines that were asked for, each with its name at the top, one lower than the other where they are close.
std::string drawn_lines(const Plot& plot, const Axes& axes) {
    std::string svg;
    double last = -INFINITY, top = kTop + 14;
    for (const PlotLine& line : plot.lines) {
        const double x = axes.x.at(line.x);
        top = x - last < 60 ? top + 16 : kTop + 14;
        last = x;
        svg +=
            svg_polyline({{x, axes.y.from}, {x, axes.y.to}}, kSvgSoft, " stroke-dasharray=\"4 4\"") +
            (x > axes.x.to - kLabelWidth ? svg_text({x - 4, top}, line.label, TextAnchor::end, kSvgSoft)
                                         : svg_text({x + 4, top}, line.label, TextAnchor::start, kSvgSoft));
    }
    return svg;
}

}  // namespace

std::string plot_svg(const Plot& plot) {
    const Axes axes = axes_of(plot);
    std::string drawn;
    std::vector<LegendEntry> legend;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const bool front = plot.curves[i].style == PlotStyle::front;
        const std::string_view colour = front ? kSvgSoft : series_colour(i);
        const std::string curve = drawn_curve(plot.curves[i], axes, colour);
        if (curve.empty()) continue;
        drawn += curve;
        legend.push_back({plot.curves[i].name, colour, front});
    }
    if (drawn.empty()) drawn = svg_text({kWidth / 2, kHeight / 2}, "nothing to draw", TextAnchor::middle);
    const SvgPoint middle = {(kLeft + kWidth - kRight) / 2, (kTop + kHeight - kBottom) / 2};
    return svg_picture(plot.title, kWidth, kHeight,
                       grid(axes) + drawn_lines(plot, axes) + drawn +
                           svg_legend({kWidth - kRight + 12, kTop + 8}, legend) +
                           svg_text({middle.x, kHeight - 12}, plot.x.label, TextAnchor::middle) +
                           svg_upward_text({16, middle.y}, plot.y.label));
}

std::string log_log_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                         const std::vector<PlotCurve>& curves) {
    return plot_svg({title, {x_label, true}, {y_label, true}, curves});
}

}  // namespace crevice
