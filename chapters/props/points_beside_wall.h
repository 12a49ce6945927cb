// What points in a half ball, and rays, find of an endless wall: for chapters 13 and 14.
#pragma once

#include <cmath>

#include "chapters/notebook/plot.h"
#include "ssao/methods/hemisphere_samples.h"

namespace crevice {

// On a floor, `distance` radii from the wall: the share of the points that lies on this side of it, over all turns about
// the normal.
inline double points_beside_wall(HemisphereLengths lengths, double distance) {
    constexpr int kMany = 4096;
    double beyond = 0;
    for (const glm::vec3& point : hemisphere_points(kMany, lengths, 1)) {
        const double across = std::hypot(static_cast<double>(point.x), static_cast<double>(point.y));
        if (across > distance) beyond += std::acos(distance / across) / 3.14159265358979;
    }
    return 1 - beyond / kMany;
}

// The mean distance of the points from the middle, radii.
inline double mean_length(HemisphereLengths lengths) {
    constexpr int kMany = 4096;
    double sum = 0;
    for (const glm::vec3& point : hemisphere_points(kMany, lengths, 1)) {
        const double x = point.x, y = point.y, z = point.z;
        sum += std::sqrt(x * x + y * y + z * z);
    }
    return sum / kMany;
}

// The share of the directions in which one sees a radius far.
inline double rays_beside_wall(double distance) { return 1 - (1 - distance) / 2; }

// From the wall to one radius from it.
template <class Access>
PlotCurve wall_curve(const std::string& name, const Access& access) {
    constexpr int kSteps = 50;
    PlotCurve curve{name, {}, {}, {}, {}, PlotStyle::smooth};
    for (int i = 0; i <= kSteps; ++i) {
        curve.x.push_back(static_cast<double>(i) / kSteps);
        curve.y.push_back(access(curve.x.back()));
    }
    return curve;
}

}  // namespace crevice
