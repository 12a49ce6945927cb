#include "chapters/diagrams/blur_taps.h"

#include <algorithm>

#include "chapters/diagrams/depth_section.h"

namespace crevice {

namespace {

SectionPoint point_of(const AoInputs& inputs, const SectionPlane& plane, int x) {
    const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(inputs.size().width);
    const float v = (static_cast<float>(plane.y) + 0.5f) / static_cast<float>(inputs.size().height);
    const Vec3<float> p = inputs.rays.p_view(u, v, inputs.view_depth.at(x, plane.y));
    return plane.at({p.x, p.y, p.z});
}

}  // namespace

std::string blur_taps_diagram(const AoInputs& inputs, int x, int y, const std::vector<BlurTap>& taps,
                              const std::string& title) {
    const SectionPlane plane = {x, y, {1, 0}};
    const SectionPoint centre = point_of(inputs, plane, x);
    SectionPoint low = centre, high = centre;
    for (const BlurTap& tap : taps) {
        const SectionPoint p = point_of(inputs, plane, tap.x);
        low = {std::min(low.z, p.z), std::min(low.across, p.across)};
        high = {std::max(high.z, p.z), std::max(high.across, p.across)};
    }
    const double reach = high.across - low.across, margin = 0.3 * reach;
    SectionDrawing drawing({low.z - 3 * margin, low.across - margin},
                           {high.z + 2 * margin, high.across + margin});
    drawing.surface(depth_section(inputs, plane, 2 * reach));
    const double begin = (low.z - 3 * margin) / centre.z;
    drawing.segment({begin * centre.z, begin * centre.across}, centre, kSvgSoft, true);
    for (const BlurTap& tap : taps) {
        if (tap.x == x) continue;
        drawing.point(point_of(inputs, plane, tap.x), "", tap.counts ? kSvgOpen : kSvgOccluded);
    }
    drawing.point(centre, "c", kSvgPoint);
    return drawing.svg(title, "x");
}

}  // namespace crevice
