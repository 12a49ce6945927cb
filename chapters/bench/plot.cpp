#include "chapters/bench/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chapters/html.h"

namespace crevice {

namespace {

constexpr double kWidth = 720, kHeight = 420;  // of the picture, SVG units
constexpr double kLeft = 70, kRight = 130, kTop = 40, kBottom = 55;
constexpr const char* kColours[] = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#000000", "#ff7f0e"};

// One axis: decades from `low` to `high` laid out between two SVG coordinates.
struct Axis {
    int low = 0, high = 1;  // powers of ten
    double from = 0, to = 0;

    double at(double value) const { return from + (to - from) * (std::log10(value) - low) / (high - low); }
};

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

// 0.01, 1, 100, then 10^4.
std::string power_of_ten(int exponent) {
    if (exponent > 4 || exponent < -3) return "1e" + std::to_string(exponent);
    char text[32];
    std::snprintf(text, sizeof text, "%g", std::pow(10.0, exponent));
    return text;
}

std::string line(double x1, double y1, double x2, double y2, const char* colour) {
    return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" +
           number(y2) + "\" stroke=\"" + colour + "\"/>\n";
}

std::string label(double x, double y, const std::string& words, const std::string& more = "") {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\"" + more + ">" + escape_html(words) +
           "</text>\n";
}

// The decades that hold all positive values of one coordinate.
Axis axis_over(const std::vector<PlotCurve>& curves, std::vector<double> PlotCurve::*member, double from,
               double to) {
    double low = INFINITY, high = 0;
    for (const PlotCurve& curve : curves) {
        for (const double value : curve.*member) {
            if (!(value > 0) || !std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (high == 0) return {0, 1, from, to};
    const int first = static_cast<int>(std::floor(std::log10(low))),
              last = static_cast<int>(std::ceil(std::log10(high)));
    return {first, std::max(last, first + 1), from, to};
}

std::string grid(const Axis& x, const Axis& y) {
    std::string svg;
    for (int e = x.low; e <= x.high; ++e) {
        const double at = x.at(std::pow(10.0, e));
        svg += line(at, y.from, at, y.to, "#ddd") +
               label(at, y.from + 18, power_of_ten(e), " text-anchor=\"middle\"");
    }
    for (int e = y.low; e <= y.high; ++e) {
        const double at = y.at(std::pow(10.0, e));
        svg += line(x.from, at, x.to, at, "#ddd") +
               label(x.from - 6, at + 4, power_of_ten(e), " text-anchor=\"end\"");
    }
    return svg;
}

std::string drawn_curve(const PlotCurve& curve, const Axis& x, const Axis& y, const std::string& colour) {
    std::string points, dots;
    double last_x = 0, last_y = 0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!(curve.x[i] > 0) || !(curve.y[i] > 0)) continue;
        last_x = x.at(curve.x[i]);
        last_y = y.at(curve.y[i]);
        points += number(last_x) + "," + number(last_y) + " ";
        dots += "<circle cx=\"" + number(last_x) + "\" cy=\"" + number(last_y) + "\" r=\"3\" fill=\"" +
                colour + "\"/>";
    }
    if (points.empty()) return "";
    return "<polyline fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.5\" points=\"" + points +
           "\"/>\n" + dots + "\n" + label(last_x + 8, last_y + 4, curve.name, " fill=\"" + colour + "\"");
}

}  // namespace

std::string log_log_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                         const std::vector<PlotCurve>& curves) {
    const Axis x = axis_over(curves, &PlotCurve::x, kLeft, kWidth - kRight),
               y = axis_over(curves, &PlotCurve::y, kHeight - kBottom, kTop);
    std::string drawn;
    for (std::size_t i = 0; i < curves.size(); ++i)
        drawn += drawn_curve(curves[i], x, y, kColours[i % std::size(kColours)]);
    if (drawn.empty()) drawn = label(kWidth / 2, kHeight / 2, "nothing to draw", " text-anchor=\"middle\"");
    const std::string middle_y = number((kTop + kHeight - kBottom) / 2);
    return "<svg viewBox=\"0 0 " + number(kWidth) + " " + number(kHeight) + "\" width=\"" + number(kWidth) +
           "\" font-family=\"sans-serif\" font-size=\"12\" style=\"background:#fff\" role=\"img\">\n<title>" +
           escape_html(title) + "</title>\n" + label(kLeft, 22, title, " font-size=\"15\"") + grid(x, y) +
           drawn + label((kLeft + kWidth - kRight) / 2, kHeight - 12, x_label, " text-anchor=\"middle\"") +
           label(16, (kTop + kHeight - kBottom) / 2, y_label,
                 " text-anchor=\"middle\" transform=\"rotate(-90 16 " + middle_y + ")\"") +
           "</svg>\n";
}

}  // namespace crevice
