#include "chapters/props/depth_error_plot.h"
#include "chapters/terminal/number_text.h"

#include <algorithm>
#include <utility>

namespace crevice {

namespace {

Camera camera_between(std::pair<double, double> planes, const DepthKind& kind) {
    Camera camera;
    camera.near_plane = planes.first, camera.far_plane = planes.second;
    camera.reversed_z = kind.reversed_z;
    return camera;
}

// Calls body(z, error) for 32 depths an octave, none of them a round number.
void each_depth(const Camera& camera, DepthFormat format, const auto& body) {
    for (double octave = camera.near_plane; octave < camera.far_plane; octave *= 2) {
        for (int i = 0; i < 32; ++i) {
            const double z = octave * (1 + (i + 0.37) / 32);
            if (z < camera.far_plane) body(z, depth_error(camera, format, z));
        }
    }
}

}  // namespace

DepthErrorTable depth_error_table() {
    constexpr std::pair<double, double> kPlanes[] = {{1, 1e3}, {0.1, 1e3}, {1e-3, 1e3}, {1e-4, 1e7},
                                                     {1, 100}, {0.5, 5},   {0.01, 50},  {10, 1e6}};
    DepthErrorTable table;
    table.header = {"near .. far"};
    for (const DepthKind& kind : kDepthKinds) table.header.push_back(kind.name);
    table.header.push_back("D24, rebuilt in float");
    for (const auto& planes : kPlanes) {
        table.rows.push_back({exact_text(static_cast<float>(planes.first)) + " .. " +
                              exact_text(static_cast<float>(planes.second))});
        double in_float = 0;
        for (const DepthKind& kind : kDepthKinds) {
            double worst = 0;
            each_depth(camera_between(planes, kind), kind.format, [&](double z, const DepthError& e) {
                worst = std::max(worst, e.error / z);
                table.most_of_bound = std::max(table.most_of_bound, e.error / e.bound);
                if (kind.format == DepthFormat::d24) in_float = std::max(in_float, e.error_in_float / z);
            });
            if (kind.reversed_z) table.worst_reversed = std::max(table.worst_reversed, worst);
            table.rows.back().push_back(significant_text(worst, 2));
        }
        table.rows.back().push_back(significant_text(in_float, 2));
    }
    return table;
}

Plot depth_error_plot() {
    Plot plot{"Relative error of a stored view depth",
              {"view depth z, scene units", true, 1, 1000},
              {"largest error / z", true, 1e-9, 0.1},
              {}};
    for (const DepthKind& kind : kDepthKinds) {
        if (kind.format == DepthFormat::d32f && !kind.reversed_z) continue;
        PlotCurve measured{std::string(kind.name) + ", measured", {}, {}, {}, {}, PlotStyle::dots};
        PlotCurve bound{std::string(kind.name) + ", bound", {}, {}, {}, {}, PlotStyle::smooth};
        each_depth(camera_between({1, 1000}, kind), kind.format, [&](double z, const DepthError& e) {
            measured.x.push_back(z);
            measured.y.push_back(e.error / z);
            bound.x.push_back(z);
            bound.y.push_back(e.bound / z);
        });
        plot.curves.push_back(measured);
        plot.curves.push_back(bound);
    }
    return plot;
}

}  // namespace crevice
