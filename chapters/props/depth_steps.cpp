#include "chapters/props/depth_steps.h"

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

}  // namespace crevice
