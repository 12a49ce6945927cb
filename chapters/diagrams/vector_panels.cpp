#include "chapters/diagrams/vector_panels.h"

#include <cmath>

#include "chapters/notebook/svg.h"

namespace crevice {

namespace {

// SVG units: of a panel, and of a vector of length 1.
constexpr double kWidth = 210, kHeight = 220, kTop = 34, kUnit = 54;

SvgPoint end_of(glm::vec3 v, SvgPoint origin, double unit) {
    const double x = static_cast<double>(v.x), y = static_cast<double>(v.y), z = static_cast<double>(v.z);
    return {origin.x + unit * (x + 0.35 * z), origin.y - unit * (y + 0.25 * z)};
}

std::string arrow(SvgPoint from, SvgPoint to, std::string_view colour, bool dashed) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    std::string svg = svg_polyline({from, to}, colour, dashed ? " stroke-dasharray=\"4 4\"" : "");
    if (length < 1) return svg;
    const double x = 6 * (to.x - from.x) / length, y = 6 * (to.y - from.y) / length;
    return svg +
           svg_polyline({{to.x - x - y / 2, to.y - y + x / 2}, to, {to.x - x + y / 2, to.y - y - x / 2}},
                        colour);
}

}  // namespace

std::string vector_panels(const std::string& title, const std::vector<VectorPanel>& panels) {
    std::string svg;
    double left = 0;
    for (const VectorPanel& panel : panels) {
        const SvgPoint origin = {left + kWidth / 2, kTop + kHeight / 2};
        svg += svg_ring(origin, kUnit, kSvgGrid);
        for (const DrawnVector& drawn : panel.vectors) {
            const SvgPoint end = end_of(drawn.v, origin, kUnit);
            svg += arrow(origin, end, drawn.colour, drawn.dashed);
            if (!drawn.label.empty())
                svg += svg_text({end.x + 5, end.y - 4}, drawn.label, TextAnchor::start, drawn.colour);
        }
        svg += svg_text({origin.x, kTop + kHeight + 8}, panel.words, TextAnchor::middle, kSvgSoft);
        left += kWidth;
    }
    return svg_picture(title, left, kTop + kHeight + 22, svg);
}

}  // namespace crevice
