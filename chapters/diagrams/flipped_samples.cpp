#include "chapters/diagrams/flipped_samples.h"

#include "chapters/diagrams/depth_section.h"
#include "chapters/notebook/svg.h"

namespace crevice {

std::string flipped_samples_diagram(const AoInputs& inputs, int x, int y, const Explanation& texel,
                                    double radius, const std::vector<float>& facing,
                                    const std::string& title) {
    const SectionPlane plane{x, y, {0, 1}};
    const SectionPoint p = plane.at(texel.p_view);
    const double reach = 1.5 * radius;
    SectionDrawing drawing({p.z - 1.2 * reach, p.across - 0.9 * reach},
                           {p.z + 1.2 * reach, p.across + 0.9 * reach});
    drawing.surface(depth_section(inputs, plane, 3 * reach));
    drawing.circle(p, radius, kSvgSoft);
    for (std::size_t i = 0; i < texel.samples.size(); ++i) {
        const SectionPoint q = plane.at(texel.samples[i].q_view);
        if (facing[i] < 0) {
            const SectionPoint before = plane.at(texel.p_view - texel.samples[i].offset);
            drawing.segment(before, p, kSvgSoft, true);
            drawing.point(before, "", kSvgSoft, SectionDrawing::Dot::ring);
        }
        drawing.segment(p, q, kSvgOpen);
        drawing.point(q, "", kSvgOpen);
    }
    const SectionPoint tip = plane.at(texel.p_view + 1.1f * static_cast<float>(radius) * texel.n_view);
    drawing.arrow(p, tip, kSvgPoint);
    drawing.label(tip, 6, 2, "n", kSvgPoint);
    drawing.point(p, "", kSvgPoint);
    drawing.label(p, 6, 20, "p", kSvgPoint);
    return drawing.svg(title);
}

}  // namespace crevice
