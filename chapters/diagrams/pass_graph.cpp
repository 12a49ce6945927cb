#include "chapters/diagrams/pass_graph.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "chapters/notebook/svg.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

// SVG units.
constexpr double kPassGraphTop = 64, kPassGraphRow = 66, kLine = 15;
constexpr double kInputLeft = 8, kInputWidth = 140, kPassLeft = 186, kPassWidth = 134, kImageLeft = 410,
                 kImageWidth = 222;

std::string box(double left, double middle, double width, double height, double roundness,
                std::string_view colour) {
    return "<rect x=\"" + svg_number(left) + "\" y=\"" + svg_number(middle - height / 2) + "\" width=\"" +
           svg_number(width) + "\" height=\"" + svg_number(height) + "\" rx=\"" + svg_number(roundness) +
           "\" fill=\"none\" stroke=\"" + std::string(colour) + "\" stroke-width=\"1.5\"/>\n";
}

// Lines of text around the middle of a box.
std::string lines(double left, double width, double middle, const std::vector<std::string>& words) {
    std::string svg;
    double y = middle - kLine * (static_cast<double>(words.size()) - 1) / 2 + 4;
    for (std::size_t i = 0; i < words.size(); ++i, y += kLine)
        svg += svg_text({left + width / 2, y}, words[i], TextAnchor::middle, i == 0 ? kSvgInk : kSvgSoft);
    return svg;
}

std::string arrow(SvgPoint from, SvgPoint to, std::string_view colour) {
    constexpr double kHead = 8;
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const double x = kHead * (to.x - from.x) / length, y = kHead * (to.y - from.y) / length;
    return svg_line(from, to, colour) +
           svg_polyline({{to.x - x - y / 2, to.y - y + x / 2}, to, {to.x - x + y / 2, to.y - y - x / 2}},
                        colour);
}

}  // namespace

std::string GraphImage::size_words() const {
    const double megabytes = 1e-6 * static_cast<double>(size.width) * size.height * bytes;
    return std::to_string(size.width) + " x " + std::to_string(size.height) + ", " +
           decimal_text(megabytes, 2) + " MB";
}

std::string pass_graph(const std::string& title, const std::vector<GraphPass>& passes) {
    std::map<std::string, double> middles;
    double y = kPassGraphTop;
    for (const GraphPass& pass : passes) {
        middles[pass.name] = y;
        y += kPassGraphRow * static_cast<double>(std::max<std::size_t>(pass.writes.size(), 1));
    }
    // Several images may reach one pass: each line ends a little below the one before.
    std::map<std::string, int> arrived;
    std::string svg;
    for (const GraphPass& pass : passes) {
        const double middle = middles[pass.name];
        if (!pass.from_outside.empty()) {
            svg += box(kInputLeft, middle, kInputWidth, 34, 0, kSvgGrid);
            svg += lines(kInputLeft, kInputWidth, middle, {pass.from_outside});
            svg += arrow({kInputLeft + kInputWidth, middle}, {kPassLeft, middle}, kSvgSoft);
        }
        svg += box(kPassLeft, middle, kPassWidth, 44, 14, kSvgInk);
        svg += lines(kPassLeft, kPassWidth, middle, {pass.name});
        double image = middle;
        for (const GraphImage& written : pass.writes) {
            svg += box(kImageLeft, image, kImageWidth, 54, 0, kSvgSoft);
            svg +=
                lines(kImageLeft, kImageWidth, image, {written.name, written.format, written.size_words()});
            svg += arrow({kPassLeft + kPassWidth, middle - 10}, {kImageLeft, image - 10}, kSvgInk);
            for (const std::string& reader : written.read_by) {
                const double end = middles[reader] + 2 + 9 * arrived[reader]++;
                svg += arrow({kImageLeft, image + 10}, {kPassLeft + kPassWidth, end}, kSvgSoft);
            }
            image += kPassGraphRow;
        }
    }
    return svg_picture(title, kImageLeft + kImageWidth + kInputLeft, y - kPassGraphRow / 2 + 6, svg);
}

}  // namespace crevice
