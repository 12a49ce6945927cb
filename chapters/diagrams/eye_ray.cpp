#include "chapters/diagrams/eye_ray.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "chapters/diagrams/depth_section.h"

namespace crevice {

std::string eye_ray(const AoInputs& inputs, int x, int y, Vec3<float> p_view) {
    const SectionPlane plane{x, y, {0, 1}};
    const SectionPoint p = plane.at({p_view.x, p_view.y, p_view.z});
    const double slope = static_cast<double>(inputs.rays.ray_scale.y), end = 1.4 * p.z;
    const double near = static_cast<double>(inputs.near_plane);
    // Of what the plane cuts only the ground, up to where something stands in front of it.
    std::vector<SectionPoint> ground = depth_section(inputs, plane, 2 * slope * end);
    std::erase_if(ground, [](const SectionPoint& point) { return std::isinf(point.z); });
    ground.erase(std::is_sorted_until(ground.begin(), ground.end(),
                                      [](const SectionPoint& a, const SectionPoint& b) { return a.z < b.z; }),
                 ground.end());
    SectionDrawing drawing({-0.12 * end, -0.42 * end}, {end, 0.42 * end});
    drawing.surface(ground);
    for (const double side : {-slope, slope}) drawing.segment({0, 0}, {end, side * end}, kSvgSoft, true);
    drawing.segment({near, -slope * near}, {near, slope * near}, kSvgSoft);
    drawing.words({near, slope * near}, -66, -8, "near plane");
    drawing.words({0, 0}, -34, 24, "the eye");
    drawing.segment({0, 0}, p, kSvgOpen);
    drawing.point({0, 0}, "", kSvgInk);
    drawing.point({near, near * p.across / p.z}, "e", kSvgOpen, SectionDrawing::Dot::ring);
    drawing.point(p, "p", kSvgPoint);
    return drawing.svg("The eye's ray through a texel");
}

}  // namespace crevice
