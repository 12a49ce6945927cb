#include "chapters/props/depth_steps.h"

#include "chapters/terminal/number_text.h"

namespace crevice {

PlotCurve step_curve(const std::string& name, Camera camera, DepthFormat format, bool reversed) {
    camera.reversed_z = reversed;
    PlotCurve curve{name, {}, {}, {}, {}, PlotStyle::smooth};
    for (double z = camera.near_plane * 1.01; z < camera.far_plane; z *= 1.1) {
        curve.x.push_back(z);
        curve.y.push_back(depth_step(camera, format, z));
    }
    return curve;
}

double half_float_limit(double length) {
    double z = 1;
    while (z * 0x1p-10 <= length) z *= 2;
    return z;
}

PlotCurve ndc_curve(const CameraMatrices& m) {
    PlotCurve curve{"d = A + B / z", {}, {}, {}, {}, PlotStyle::smooth};
    for (double z = 1; z <= 20; z += 0.125) {
        curve.x.push_back(z);
        curve.y.push_back(static_cast<double>(m.depth_a) + static_cast<double>(m.depth_b) / z);
    }
    return curve;
}

std::vector<std::vector<std::string>> d24_rows(const CameraMatrices& m) {
    constexpr float kSteps = 16777216;  // of D24
    std::vector<std::vector<std::string>> rows;
    for (const float z : {1.0f, 2.0f, 10.0f, 100.0f, 1000.0f}) {
        rows.push_back({exact_text(z), exact_text(m.depth_a + m.depth_b / z),
                        significant_text(static_cast<double>(z * z / -m.depth_b / kSteps), 3)});
    }
    return rows;
}

}  // namespace crevice
