#include "chapters/diagrams/slice_section.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "chapters/diagrams/drawn_slice.h"
#include "ssao/methods/gtao_kernel.h"

namespace crevice {

namespace {

// calls visit(texel, slice, radius in pixels, shift) for slice `number` of a texel.
template <class Visit>
void visit_slice(const GtaoKernel& kernel, int x, int y, int number, const Visit& visit) {
    const TexelPoint<float> texel = texel_point<float>(kernel.inputs, x, y);
    kernel.for_each_slice(texel, [&](const Slice<float>& slice, int i, float radius_px, float shift) {
        if (i == number) visit(texel, slice, radius_px, shift);
    });
}

}  // namespace

std::string horizon_diagram(const AoInputs& inputs, const HbaoSettings& settings, int x, int y,
                            const Explanation& explanation, std::size_t first, const std::string& title) {
    DrawnSlice drawn;
    drawn.plane = plane_through(x, y, explanation.samples[first]);
    drawn.p = explanation.p_view;
    drawn.n = explanation.n_view;
    drawn.v = -glm::normalize(drawn.p);
    const glm::vec3 way(drawn.plane.towards, 0);
    drawn.t = glm::normalize(way - glm::dot(way, drawn.v) * drawn.v);
    drawn.radius = static_cast<double>(settings.radius);
    const double tangent = drawn.gamma() + kQuarter;
    const double least = tangent - static_cast<double>(settings.bias) * kPi / 180;
    SectionDrawing drawing = drawn.drawing(inputs);
    double horizon = least;
    for (std::size_t i = first; i < first + static_cast<std::size_t>(settings.steps); ++i) {
        const ExplainedSample& sample = explanation.samples[i];
        const bool raises = sample.contribution > 0;
        const glm::vec3 way_to = sample.r_view - drawn.p;
        if (raises)
            horizon = std::min(horizon, static_cast<double>(std::atan2(glm::dot(way_to, drawn.t),
                                                                       glm::dot(way_to, drawn.v))));
        drawing.point(drawn.plane.at(sample.r_view), "r_" + std::to_string(i - first + 1),
                      raises ? kSvgOccluded : kSvgOpen,
                      raises ? SectionDrawing::Dot::filled : SectionDrawing::Dot::ring);
    }
    if (horizon < least) drawing.area(drawn.wedge(horizon, least, 0, drawn.radius), kSvgOccluded);
    drawing.area(drawn.wedge(0, horizon, 0, drawn.radius), kSvgOpen);
    drawing.segment(drawn.at(0, 0), drawn.at(kQuarter, drawn.radius), kSvgSoft, true);
    drawing.segment(drawn.at(0, 0), drawn.at(tangent, drawn.radius), kSvgPoint, true);
    drawing.segment(drawn.at(0, 0), drawn.at(least, drawn.radius), kSvgPoint);
    drawing.segment(drawn.at(0, 0), drawn.at(horizon, drawn.radius), kSvgOccluded);
    drawing.path(drawn.arc(kQuarter, horizon, 0.5 * drawn.radius), kSvgOccluded);
    drawn.mark(drawing, (2 * horizon + kQuarter) / 3, 0.56 * drawn.radius, "h", kSvgOccluded);
    drawing.path(drawn.arc(kQuarter, least, 0.3 * drawn.radius), kSvgPoint);
    drawn.mark(drawing, (least + kQuarter) / 2, 0.36 * drawn.radius, "t", kSvgPoint);
    drawn.arrow(drawing, 0, 0.9 * drawn.radius, "v", kSvgSoft);
    drawn.arrow(drawing, drawn.gamma(), 0.75 * drawn.radius, "n", kSvgPoint);
    drawing.point(drawn.plane.at(drawn.p), "p", kSvgPoint);
    return drawing.svg(title, "across");
}

SliceHorizons slice_horizons(const AoInputs& inputs, const GtaoSettings& settings, int x, int y, int number) {
    const GtaoKernel kernel(inputs, settings, {});
    SliceHorizons found;
    visit_slice(kernel, x, y, number,
                [&](const TexelPoint<float>& texel, const Slice<float>& slice, float radius_px, float shift) {
                    const auto side = [&](float sign) {
                        found.lost += kernel.lost(texel, slice, number, sign, radius_px, shift, NoWitness{});
                        return arc_cosine(kernel.horizon_of(texel, slice, number, sign, radius_px, shift).c);
                    };
                    found.behind = side(1);
                    found.before = -side(-1);
                    found.gamma = slice.gamma;
                    found.length = slice.length;
                });
    return found;
}

std::string slice_diagram(const AoInputs& inputs, const GtaoSettings& settings, int x, int y, int number,
                          const std::string& title) {
    const GtaoKernel kernel(inputs, settings, {});
    const SliceHorizons angles = slice_horizons(inputs, settings, x, y, number);
    std::string svg;
    visit_slice(
        kernel, x, y, number,
        [&](const TexelPoint<float>& texel, const Slice<float>& slice, float radius_px, float shift) {
            const DrawnSlice drawn = drawn_slice(texel, slice, static_cast<double>(kernel.reach));
            const double r = drawn.radius, gamma = static_cast<double>(slice.gamma);
            const double before = static_cast<double>(angles.before),
                         behind = static_cast<double>(angles.behind);
            SectionDrawing drawing = drawn.drawing(inputs);
            drawing.area(drawn.wedge(before, behind, 0, r), kSvgOpen);
            drawing.area(drawn.wedge(behind, std::max(behind, gamma + kQuarter), 0, r), kSvgOccluded);
            drawing.area(drawn.wedge(std::min(before, gamma - kQuarter), before, 0, r), kSvgOccluded);
            for (const float sign : {1.0f, -1.0f}) {
                const auto highest = kernel.horizon_of(texel, slice, number, sign, radius_px, shift).highest;
                const double h = sign > 0 ? behind : before;
                drawing.segment(drawn.at(0, 0), drawn.at(h, r), kSvgOccluded);
                drawing.path(drawn.arc(0, h, (sign > 0 ? 0.5 : 0.42) * r), kSvgInk);
                drawn.mark(drawing, 0.6 * h, (sign > 0 ? 0.57 : 0.48) * r, sign > 0 ? "h_2" : "h_1", kSvgInk);
                if (highest.weight > 0) drawing.point(drawn.plane.at(as_glm(highest.q)), "r", kSvgOccluded);
            }
            drawing.path(drawn.arc(0, gamma, 0.24 * r), kSvgPoint);
            drawn.mark(drawing, gamma / 2, 0.3 * r, "γ", kSvgPoint);
            drawn.arrow(drawing, 0, 0.9 * r, "v", kSvgSoft);
            drawn.arrow(drawing, gamma, 0.75 * r, "n_p", kSvgPoint);
            drawing.point(drawn.plane.at(drawn.p), "p", kSvgPoint);
            svg = drawing.svg(title, "across");
        });
    return svg;
}

}  // namespace crevice
