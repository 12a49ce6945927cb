// Curves as a picture inside an HTML page.
#pragma once

#include <string>
#include <vector>

namespace crevice {

enum class PlotStyle {
    line,   // a dot at each point, and a line through them in their order
    dots,   // the dots alone
    front,  // a ring round each point, and a dashed line: marks the best points of other series
};

struct PlotCurve {
    std::string name;          // in the legend
    std::vector<double> x, y;  // of one length; points not finite or not above 0 are left out
    std::vector<double> y_low = {}, y_high = {};  // empty, or one a point: a bar from low to high
    PlotStyle style = PlotStyle::line;
};

// An <svg> with logarithmic axes over whole decades and a legend beside them; where nothing can be drawn, it
// says so. A bar that reaches down to 0 or below is drawn to the bottom.
std::string log_log_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                         const std::vector<PlotCurve>& curves);

}  // namespace crevice
