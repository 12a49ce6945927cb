#include "chapters/diagrams/group_apron.h"

#include <algorithm>

#include "chapters/notebook/svg.h"

namespace crevice {

namespace {

constexpr double kSide = 420, kGroupApronTop = 36, kGroupApronLeft = 10;  // SVG units
const std::string_view kStrayed = series_colour(1);                       // orange

std::string outline(SvgPoint a, SvgPoint b, std::string_view colour, std::string_view more) {
    return svg_polyline({a, {b.x, a.y}, b, {a.x, b.y}, a}, colour, more);
}

}  // namespace

std::string group_diagram(const PixelRect& group, int apron_px, const std::vector<TexelSamples>& texels,
                          const std::string& title) {
    const PixelRect kept = {group.x0 - apron_px, group.y0 - apron_px, group.x1 + apron_px,
                            group.y1 + apron_px};
    double reach = apron_px;  // how far samples go from the group, pixels
    for (const TexelSamples& samples : texels) {
        for (const ExplainedSample& sample : samples.texel.samples) {
            const double x = static_cast<double>(sample.q_screen.x),
                         y = static_cast<double>(sample.q_screen.y);
            reach = std::max({reach, group.x0 - x, x - group.x1, group.y0 - y, y - group.y1});
        }
    }
    const double shown = group.x1 - group.x0 + 2 * (reach + 2), scale = kSide / shown;
    const auto at = [&](double x, double y) {
        return SvgPoint{kGroupApronLeft + (x - group.x0 + reach + 2) * scale,
                        kGroupApronTop + (y - group.y0 + reach + 2) * scale};
    };
    std::string svg =
        outline(at(kept.x0, kept.y0), at(kept.x1, kept.y1), kSvgOpen, " stroke-dasharray=\"6 4\"") +
        outline(at(group.x0, group.y0), at(group.x1, group.y1), kSvgOpen, " stroke-width=\"2\"");
    for (const TexelSamples& samples : texels) {
        const SvgPoint p =
            at(static_cast<double>(samples.p_screen.x), static_cast<double>(samples.p_screen.y));
        for (const ExplainedSample& sample : samples.texel.samples) {
            const double x = static_cast<double>(sample.q_screen.x),
                         y = static_cast<double>(sample.q_screen.y);
            const bool inside = x >= kept.x0 && x < kept.x1 && y >= kept.y0 && y < kept.y1;
            const std::string_view colour = inside ? kSvgInk : kStrayed;
            svg += svg_line(p, at(x, y), colour) + svg_dot(at(x, y), 3.5, colour);
        }
        svg += svg_dot(p, 5, kSvgPoint);
    }
    svg += svg_text({at(group.x0, 0).x, at(0, group.y0).y - 5}, "group") +
           svg_text({at(kept.x0, 0).x, at(0, kept.y0).y - 5}, "apron");
    return svg_picture(title, kSide + 2 * kGroupApronLeft, kSide + kGroupApronTop + kGroupApronLeft, svg);
}

}  // namespace crevice
