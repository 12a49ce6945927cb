#include "chapters/diagrams/lookup_weights.h"

#include "chapters/notebook/svg.h"
#include "chapters/terminal/number_text.h"
#include "ssao/inputs/linear_taps.h"

namespace crevice {

namespace {

constexpr double kLeft = 20, kLookupWeightsTop = 36, kTexel = 170;  // SVG units

std::string text(float value, int decimals) { return decimal_text(static_cast<double>(value), decimals); }

}  // namespace

std::array<TexelWeight, 4> lookup_weights(Size map, Size picture, int x, int y) {
    const LinearTaps columns(picture.width, map.width), rows(picture.height, map.height);
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const float right = columns.weight_of_second[column], lower = rows.weight_of_second[row];
    return {{{columns.first[column], rows.first[row], (1 - right) * (1 - lower)},
             {columns.second[column], rows.first[row], right * (1 - lower)},
             {columns.first[column], rows.second[row], (1 - right) * lower},
             {columns.second[column], rows.second[row], right * lower}}};
}

std::string lookup_diagram(const Image<float>& ao, Size picture, int x, int y, const std::string& title) {
    const std::array<TexelWeight, 4> texels = lookup_weights(ao.size, picture, x, y);
    const double right = static_cast<double>(texels[1].weight + texels[3].weight),
                 lower = static_cast<double>(texels[2].weight + texels[3].weight);
    const SvgPoint first = {kLeft + kTexel / 2, kLookupWeightsTop + kTexel / 2};
    const SvgPoint pixel = {first.x + right * kTexel, first.y + lower * kTexel};
    std::string svg;
    for (int line = 0; line <= 4; ++line) {
        const double at = line * kTexel / 2;
        const std::string_view colour = line % 2 == 0 ? kSvgInk : kSvgGrid;
        svg +=
            svg_line({kLeft + at, kLookupWeightsTop}, {kLeft + at, kLookupWeightsTop + 2 * kTexel}, colour) +
            svg_line({kLeft, kLookupWeightsTop + at}, {kLeft + 2 * kTexel, kLookupWeightsTop + at}, colour);
    }
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const SvgPoint centre = {first.x + (i % 2 == 1 ? kTexel : 0), first.y + (i >= 2 ? kTexel : 0)};
        svg += svg_line(pixel, centre, kSvgOpen) + svg_dot(centre, 4, kSvgInk) +
               svg_text({centre.x, centre.y + (i >= 2 ? 40 : -44)},
                        "AO " + text(ao.at(texels[i].x, texels[i].y), 3), TextAnchor::middle) +
               svg_text({centre.x, centre.y + (i >= 2 ? 58 : -26)}, "w = " + text(texels[i].weight, 4),
                        TextAnchor::middle, kSvgOpen);
    }
    svg += svg_dot(pixel, 6, kSvgPoint);
    return svg_picture(title, 2 * kLeft + 2 * kTexel, kLookupWeightsTop + 2 * kTexel + kLeft, svg);
}

}  // namespace crevice
