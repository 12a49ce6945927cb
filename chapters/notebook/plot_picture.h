// Points and curves in a frame, as a picture of a notebook: pixels from + - * / and square roots only, so
// that the file is the same on every machine.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "chapters/notebook/picture.h"

namespace crevice {

// The lines of the grid carry their values in small digits; what the axes are is for the caption to say.
struct PlotFrame {
    double x_low = 0, x_high = 1;  // low < high; logarithmic: both above 0
    double y_low = 0, y_high = 1;
    // Grid lines at every power of ten within, if logarithmic, else at quarters of each axis.
    bool logarithmic = false;
};

enum class PlotMark { line, dots };

struct PlotSeries {
    std::vector<double> x, y;  // of one length; what lies outside the frame is cut off
    PlotMark mark = PlotMark::line;
    glm::vec3 colour = glm::vec3(0);  // for display, [0,1]
};

// Colours that are told apart in print and by the colour-blind (Okabe & Ito 2008).
inline constexpr glm::vec3 kPlotBlue{0, 0.447f, 0.698f}, kPlotOrange{0.835f, 0.369f, 0},
    kPlotGreen{0, 0.62f, 0.451f};

// Drawn in order, later series over earlier ones. Values that are not finite, or not above 0 in a
// logarithmic frame, are left out and break a line. Throws UsageError for a frame or a size that cannot be
// drawn in (below 64 x 48 pixels), and for a series with unlike counts.
Picture plot_picture(Size size, const PlotFrame& frame, std::span<const PlotSeries> series);

}  // namespace crevice
