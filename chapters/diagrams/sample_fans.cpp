#include "chapters/diagrams/sample_fans.h"

#include "chapters/notebook/svg.h"

namespace crevice {

namespace {

constexpr double kCell = 146, kRow = 154, kRadius = 56, kSampleFansTop = 36;  // SVG units

std::string fan_at(SvgPoint centre, const SampleFan& fan, double radius) {
    std::string svg = "<circle cx=\"" + svg_number(centre.x) + "\" cy=\"" + svg_number(centre.y) + "\" r=\"" +
                      svg_number(kRadius) + "\" fill=\"none\" stroke=\"" + std::string(kSvgSoft) +
                      "\" stroke-dasharray=\"3 4\"/>\n";
    for (const ExplainedSample& sample : fan.texel.samples) {
        const double scale = kRadius / radius;
        const SvgPoint tip = {centre.x + scale * static_cast<double>(sample.offset.x),
                              centre.y - scale * static_cast<double>(sample.offset.y)};
        const std::string_view colour = sample.contribution > 0 ? kSvgOccluded : kSvgOpen;
        svg += svg_polyline({centre, tip}, colour) + svg_dot(tip, 3, colour);
    }
    return svg + svg_dot(centre, 4, kSvgPoint) +
           svg_text({centre.x, centre.y + kRadius + 18}, fan.name, TextAnchor::middle);
}

}  // namespace

std::string sample_fans(const std::string& title, const std::vector<SampleFan>& fans, int columns,
                        double radius) {
    std::string svg;
    for (std::size_t i = 0; i < fans.size(); ++i) {
        const auto column = static_cast<double>(static_cast<int>(i) % columns);
        const auto row = static_cast<double>(static_cast<int>(i) / columns);
        svg += fan_at({kCell * (column + 0.5), kSampleFansTop + kRadius + 4 + kRow * row}, fans[i], radius);
    }
    const int rows = (static_cast<int>(fans.size()) + columns - 1) / columns;
    return svg_picture(title, kCell * columns, kSampleFansTop + kRow * rows, svg);
}

}  // namespace crevice
