#include "chapters/notebook/plot.h"

#include <algorithm>
#include <cmath>

#include "chapters/notebook/html.h"
#include "chapters/notebook/svg.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

constexpr double kWidth = 760, kHeight = 400;  // of the picture, SVG units
constexpr double kLeft = 70, kRight = 190, kTop = 40, kBottom = 55;
constexpr double kLabelWidth = 110;                 // room that the name of a dashed line may need, SVG units
constexpr double kCharacterWidth = 6.5;             // of such a name, on the average and with room, SVG units
constexpr double kSpanMargin = 12, kSpanLine = 30;  // of the bars of ratios, in the lower left corner
constexpr std::string_view kDashes = " stroke-dasharray=\"4 4\"";  // of lines that are no curves
constexpr double kCap = 4;                                         // half the height of such a bar's ends

struct Axes {
    LaidOutAxis x, y;

    bool shows(const PlotCurve& curve, std::size_t i) const {
        return x.shows(curve.x[i]) && y.shows(curve.y[i]);
    }
    SvgPoint at(double value_x, double value_y) const { return {x.at(value_x), y.at(value_y)}; }
};

Axes axes_of(const Plot& plot) {
    std::vector<double> x, y;
    const LaidOutAxis any_x{plot.x.logarithmic}, any_y{plot.y.logarithmic};
    for (const PlotCurve& curve : plot.curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (!any_x.shows(curve.x[i]) || !any_y.shows(curve.y[i])) continue;
            x.push_back(curve.x[i]);
            y.push_back(curve.y[i]);
            if (!curve.y_low.empty()) y.insert(y.end(), {curve.y_low[i], curve.y_high[i]});
            if (!curve.x_low.empty()) x.insert(x.end(), {curve.x_low[i], curve.x_high[i]});
        }
    }
    return {axis_over(plot.x, x, kLeft, kWidth - kRight), axis_over(plot.y, y, kHeight - kBottom, kTop)};
}

std::string group(const std::string& attributes, const std::string& drawn) {
    return "<g " + attributes + ">\n" + drawn + "</g>\n";
}

// What an axis shows, for a page that zooms into it: "log LOW HIGH FROM TO".
std::string axis_words(const LaidOutAxis& axis) {
    std::string words = axis.logarithmic ? "log" : "linear";
    for (const double value : {axis.low, axis.high, axis.from, axis.to}) words += " " + shortest_text(value);
    return words;
}

std::string grid(const Axes& axes) {
    std::string svg;
    const LaidOutAxis &x = axes.x, &y = axes.y;
    for (const AxisTick& tick : ticks_of(x)) {
        svg += svg_line({tick.at, y.from}, {tick.at, y.to}, kSvgGrid) +
               svg_text({tick.at, y.from + 18}, tick.label, TextAnchor::middle);
    }
    for (const AxisTick& tick : ticks_of(y)) {
        svg += svg_line({x.from, tick.at}, {x.to, tick.at}, kSvgGrid) +
               svg_text({x.from - 6, tick.at + 4}, tick.label, TextAnchor::end);
    }
    return group("class=\"grid\" data-x=\"" + axis_words(x) + "\" data-y=\"" + axis_words(y) + "\"", svg);
}

// The bars of one point, across and upright.
std::string drawn_bars(const PlotCurve& curve, std::size_t i, const Axes& axes, std::string_view colour) {
    const SvgPoint at = axes.at(curve.x[i], curve.y[i]);
    std::string bars;
    if (!curve.y_low.empty())
        bars += svg_line({at.x, axes.y.at(curve.y_low[i])}, {at.x, axes.y.at(curve.y_high[i])}, colour);
    if (!curve.x_low.empty())
        bars += svg_line({axes.x.at(curve.x_low[i]), at.y}, {axes.x.at(curve.x_high[i]), at.y}, colour);
    return bars;
}

std::string drawn_line(const PlotCurve& curve, const Axes& axes, std::string_view colour) {
    std::vector<SvgPoint> points;
    const auto add = [&](std::size_t i) {
        if (axes.shows(curve, i)) points.push_back(axes.at(curve.x[i], curve.y[i]));
    };
    for (const std::size_t i : curve.line_through) add(i);
    for (std::size_t i = 0; curve.line_through.empty() && i < curve.x.size(); ++i) add(i);
    const char* const dashes = curve.style == PlotStyle::front ? " stroke-dasharray=\"2 4\"" : "";
    return svg_polyline(points, colour, dashes);
}

// Empty when none of its points can be drawn.
std::string drawn_curve(const PlotCurve& curve, const Axes& axes, std::string_view colour) {
    std::string marks;
    bool any = false;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!axes.shows(curve, i)) continue;
        any = true;
        const SvgPoint at = axes.at(curve.x[i], curve.y[i]);
        if (curve.style == PlotStyle::front) marks += svg_ring(at, 6, colour);
        if (curve.style == PlotStyle::line || curve.style == PlotStyle::dots) {
            marks += svg_dot(at, 3, colour,
                             curve.points.empty() || curve.points[i].empty()
                                 ? ""
                                 : " data-point=\"" + escape_html(curve.points[i]) + "\"");
        }
        marks += drawn_bars(curve, i, axes, colour);
    }
    if (!any) return "";
    const bool front = curve.style == PlotStyle::front;
    return group(std::string("class=\"") + (front ? "front" : "curve") + "\" data-name=\"" +
                     escape_html(curve.name) + "\"",
                 (curve.style == PlotStyle::dots ? "" : drawn_line(curve, axes, colour)) + marks);
}

// Where an upright line is too near to the right end for its name to stand on that side.
bool name_at_the_left(const PlotLine& line, const Axes& axes) {
    return axes.x.at(line.at) > axes.x.to - kLabelWidth;
}

// An upright line with its name at its top.
std::string upright_line(const PlotLine& line, double top, const Axes& axes) {
    const double x = axes.x.at(line.at);
    const bool at_the_left = name_at_the_left(line, axes);
    return group("class=\"upright\"",
                 svg_polyline({{x, axes.y.from}, {x, axes.y.to}}, kSvgSoft, kDashes) +
                     svg_text({at_the_left ? x - 4 : x + 4, top}, line.label,
                              at_the_left ? TextAnchor::end : TextAnchor::start, kSvgSoft));
}

// A level line with its name at its right end.
std::string level_line(const PlotLine& line, const Axes& axes) {
    const double y = axes.y.at(line.at);
    return group("class=\"level\"",
                 svg_polyline({{axes.x.from, y}, {axes.x.to, y}}, kSvgSoft, kDashes) +
                     svg_text({axes.x.to - 4, y - 4}, line.label, TextAnchor::end, kSvgSoft));
}

// Lines that were asked for; the names of upright ones one lower than the other where they would overlap.
std::string drawn_lines(const Plot& plot, const Axes& axes) {
    std::string svg;
    double taken_to = -INFINITY, top = kTop + 14;
    for (const PlotLine& line : plot.lines) {
        if (line.level) {
            svg += level_line(line, axes);
            continue;
        }
        const double x = axes.x.at(line.at), width = kCharacterWidth * static_cast<double>(line.label.size());
        const double from = name_at_the_left(line, axes) ? x - width : x;
        const bool is_lower = from < taken_to;
        top = is_lower ? top + 16 : kTop + 14;
        taken_to = std::max(is_lower ? taken_to : -INFINITY, from + width);
        svg += upright_line(line, top, axes);
    }
    return svg;
}

// From the lower left corner, one above the other, as far as the axis goes.
std::string drawn_spans(const Plot& plot, const Axes& axes) {
    std::string svg;
    double y = axes.y.from - kSpanMargin;
    for (const PlotSpan& span : plot.spans) {
        const double decade = (axes.x.to - axes.x.from) / (axes.x.high - axes.x.low);
        const double from = axes.x.from + kSpanMargin,
                     to =
                         std::min(from + decade * std::max(0.0, std::log10(span.high / span.low)), axes.x.to);
        svg += svg_line({from, y}, {to, y}, kSvgInk) + svg_line({from, y - kCap}, {from, y + kCap}, kSvgInk) +
               svg_line({to, y - kCap}, {to, y + kCap}, kSvgInk) + svg_text({from, y - 8}, span.label);
        y -= kSpanLine;
    }
    return svg.empty() ? "" : group("class=\"spans\"", svg);
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
    return svg_picture(
        plot.title, kWidth, kHeight,
        grid(axes) + group("class=\"marks\"", drawn_lines(plot, axes) + drawn + drawn_spans(plot, axes)) +
            svg_legend({kWidth - kRight + 12, kTop + 8}, legend) +
            svg_text({middle.x, kHeight - 12}, plot.x.label, TextAnchor::middle) +
            svg_upward_text({16, middle.y}, plot.y.label));
}

std::string log_log_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                         const std::vector<PlotCurve>& curves) {
    return plot_svg({title, {x_label, true}, {y_label, true}, curves});
}

}  // namespace crevice
