// Curves as an SVG inside a page: axes with their units, ticks and a legend.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace crevice {

enum class PlotStyle {
    line,    // a dot at each point, and a line through them in their order
    smooth,  // the line alone
    dots,    // the dots alone
    front,   // a ring round each point, and a dashed line: marks the best points of other series
};

struct PlotCurve {
    std::string name;          // in the legend
    std::vector<double> x, y;  // of one length; points that the axes cannot show are left out
    std::vector<double> y_low = {}, y_high = {};  // empty, or one a point: a bar from low to high
    PlotStyle style = PlotStyle::line;
};

// An axis from `low` to `high`; where they are NaN, as far as the curves go, in whole ticks or decades.
struct PlotAxis {
    std::string label;  // what, and in which unit
    bool logarithmic = false;
    double low = std::numeric_limits<double>::quiet_NaN(), high = std::numeric_limits<double>::quiet_NaN();
};

// A dashed line at one x, with its name.
struct PlotLine {
    double x = 0;
    std::string label;
};

struct Plot {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotCurve> curves;
    std::vector<PlotLine> lines = {};
};

// An <svg>; where nothing can be drawn, it says so. A bar that reaches below what a logarithmic axis can show is drawn to
// the bottom.
std::string plot_svg(const Plot& plot);

// With logarithmic axes over whole decades.
std::string log_log_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                         const std::vector<PlotCurve>& curves);

}  // namespace crevice
