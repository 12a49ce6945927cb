// The axes of a plot: which value lies where, and which values are named.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace crevice {

// An axis from `low` to `high`; where they are NaN, as far as the curves go, in whole ticks or decades.
struct PlotAxis {
    std::string label;  // what, and in which unit
    bool logarithmic = false;
    double low = std::numeric_limits<double>::quiet_NaN(), high = std::numeric_limits<double>::quiet_NaN();
};

// One axis laid out between two SVG coordinates. A logarithmic one counts in decades.
struct LaidOutAxis {
    bool logarithmic = false;
    double low = 0, high = 1;  // values, or their powers of ten
    double from = 0, to = 0;

    bool shows(double value) const;
    // Where the axis begins for a value that it cannot show.
    double at(double value) const;
};

// What holds all these values, or what the plot asks for.
LaidOutAxis axis_over(const PlotAxis& asked, const std::vector<double>& values, double from, double to);

struct AxisTick {
    double at;  // SVG coordinate
    std::string label;
};

// The decades; twice and five times each where there are no more than two. Or steps of one width.
std::vector<AxisTick> ticks_of(const LaidOutAxis& axis);

// As far as these values go and a little further, to 1, 2 or 5 times a power of ten: a logarithmic axis that keeps less room
// free than whole decades do.
PlotAxis snug_axis(const std::string& label, const std::vector<double>& values);

}  // namespace crevice
