#include "chapters/diagrams/point_cloud.h"

#include <cmath>

#include "chapters/diagrams/depth_section.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

namespace {

// Over p, on the side of a direction of the plane.
std::vector<SectionPoint> half_circle(SectionPoint p, SectionPoint direction, double radius) {
    constexpr int kSteps = 48;
    const double middle = std::atan2(direction.across, direction.z);
    std::vector<SectionPoint> arc;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = middle - kPi / 2 + kPi * i / kSteps;
        arc.push_back({p.z + radius * std::cos(angle), p.across + radius * std::sin(angle)});
    }
    return arc;
}

}  // namespace

std::size_t strongest_sample(const Explanation& explanation) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < explanation.samples.size(); ++i) {
        if (explanation.samples[i].contribution > explanation.samples[best].contribution) best = i;
    }
    return best;
}

std::string hemisphere_diagram(const AoInputs& inputs, int x, int y, const Explanation& explanation,
                               std::size_t through, double radius, const std::string& title) {
    const SectionPlane plane = plane_through(x, y, explanation.samples[through]);
    const SectionPoint p = plane.at(explanation.p_view), n = plane.at(explanation.n_view);
    const double reach = 1.35 * radius;
    SectionDrawing drawing({p.z - 1.5 * reach, p.across - reach}, {p.z + 1.1 * reach, p.across + reach});
    drawing.surface(depth_section(inputs, plane, 3 * reach));
    const std::vector<SectionPoint> arc = half_circle(p, n, radius);
    for (std::size_t i = 1; i < arc.size(); ++i) drawing.segment(arc[i - 1], arc[i], kSvgSoft);
    drawing.segment(arc.front(), arc.back(), kSvgSoft, true);
    const SectionPoint tip = {p.z + 0.5 * radius * n.z, p.across + 0.5 * radius * n.across};
    drawing.arrow(p, tip, kSvgPoint);
    drawing.label(tip, 6, 2, "n", kSvgPoint);
    for (const ExplainedSample& sample : explanation.samples) {
        constexpr double kNear = 0.3;  // radii from the plane
        const double beside =
            static_cast<double>(sample.offset.y * plane.towards.x - sample.offset.x * plane.towards.y);
        if (std::fabs(beside) > kNear * radius) continue;
        const bool takes = sample.contribution > 0;
        drawing.point(plane.at(sample.q_view), "", takes ? kSvgOccluded : kSvgOpen,
                      takes ? SectionDrawing::Dot::filled : SectionDrawing::Dot::ring);
    }
    drawing.point(p, "p", kSvgPoint);
    drawing.words({p.z - 1.5 * reach, p.across}, 6, -6, "the eye is on this side");
    return drawing.svg(title, "across");
}

}  // namespace crevice
