// Curves as a picture inside an HTML page.
#pragma once

#include <string>
#include <vector>

namespace crevice {

struct PlotCurve {
    std::string name;
    std::vector<double> x, y;  // of one length; values that are not above 0 are left out
};

// An <svg> with logarithmic axes, a line through each curve's points and its name at the end; where nothing
// can be drawn, it says so.
std::string log_log_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                         const std::vector<PlotCurve>& curves);

}  // namespace crevice
