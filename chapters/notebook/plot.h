// Curves as an SVG inside a page: axes with their units, ticks and a legend.
// Page: the marks of each curve stand in <g class="curve" data-name="NAME">, all marks in <g class="marks">, the ticks in
//       <g class="grid"> with what its axes show; plots.js zooms, filters and tells points by these
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "chapters/notebook/plot_axis.h"

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
    std::vector<double> x_low = {}, x_high = {};  // the same across
    std::vector<std::size_t> line_through = {};   // the points that the line goes through; empty: all
    std::vector<std::string> points = {};         // empty, or the name of each dot in the page, as data-point
};

// A dashed line with its name.
struct PlotLine {
    double at = 0;  // its x
    std::string label;
    bool level = false;  // `at` is its y
};

// A bar as long as from `low` to `high`, ratios of two x on a logarithmic axis: how far apart equals may lie.
struct PlotSpan {
    double low = 1, high = 1;
    std::string label;
};

struct Plot {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotCurve> curves;
    std::vector<PlotLine> lines = {};
    std::vector<PlotSpan> spans = {};
};

// An <svg>; where nothing can be drawn, it says so. A bar that reaches below what a logarithmic axis can show is drawn to
// the bottom.
std::string plot_svg(const Plot& plot);

// With logarithmic axes over whole decades.
std::string log_log_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                         const std::vector<PlotCurve>& curves);

}  // namespace crevice
