#include "chapters/notebook/svg.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "chapters/notebook/html.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr double kLegendLine = 18;  // from one name to the next

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}
std::string attribute(std::string_view name, double value) { return attribute(name, svg_number(value)); }

}  // namespace

std::string svg_number(double value) {
    // Never "-0.0".
    return decimal_text(std::fabs(value) < 0.05 ? 0.0 : value, 1);
}

std::string svg_line(SvgPoint from, SvgPoint to, std::string_view colour) {
    return "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
           attribute("y2", to.y) + attribute("stroke", colour) + "/>\n";
}

std::string svg_polyline(const std::vector<SvgPoint>& points, std::string_view colour,
                         std::string_view more) {
    std::string text;
    for (const SvgPoint& p : points) text += svg_number(p.x) + "," + svg_number(p.y) + " ";
    const char* const width = more.find("stroke-width") == more.npos ? " stroke-width=\"1.5\"" : "";
    return "<polyline fill=\"none\"" + attribute("stroke", colour) + width + std::string(more) +
           attribute("points", text) + "/>\n";
}

std::string svg_dot(SvgPoint centre, double radius, std::string_view colour, std::string_view more) {
    return "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius) +
           attribute("fill", colour) + std::string(more) + "/>\n";
}

std::string svg_ring(SvgPoint centre, double radius, std::string_view colour) {
    return "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius) +
           " fill=\"none\"" + attribute("stroke", colour) + " stroke-width=\"1.5\"/>\n";
}

std::string svg_box(SvgPoint corner, SvgPoint opposite, std::string_view colour, std::string_view hint) {
    return "<rect" + attribute("x", std::min(corner.x, opposite.x)) +
           attribute("y", std::min(corner.y, opposite.y)) +
           attribute("width", std::fabs(corner.x - opposite.x)) +
           attribute("height", std::fabs(corner.y - opposite.y)) + attribute("fill", colour) + "><title>" +
           escape_html(hint) + "</title></rect>\n";
}

std::string svg_text(SvgPoint at, std::string_view words, TextAnchor anchor, std::string_view colour) {
    constexpr const char* kNames[] = {"start", "middle", "end"};
    return "<text" + attribute("x", at.x) + attribute("y", at.y) +
           attribute("text-anchor", kNames[static_cast<int>(anchor)]) + attribute("fill", colour) +
           // Lines pass behind words, not through them.
           attribute("stroke", kSvgPaper) + " stroke-width=\"3\" paint-order=\"stroke\">" +
           escape_html(words) + "</text>\n";
}

std::string svg_upward_text(SvgPoint middle, std::string_view words) {
    const std::string at = svg_number(middle.x) + " " + svg_number(middle.y);
    return "<text" + attribute("x", middle.x) + attribute("y", middle.y) + " text-anchor=\"middle\"" +
           attribute("transform", "rotate(-90 " + at + ")") + attribute("fill", kSvgInk) + ">" +
           escape_html(words) + "</text>\n";
}

std::string svg_picture(std::string_view title, double width, double height, std::string_view drawn) {
    return "<svg" + attribute("viewBox", "0 0 " + svg_number(width) + " " + svg_number(height)) +
           attribute("width", width) +
           " xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" font-size=\"12\" "
           "style=\"background:var(--paper,#fff);max-width:100%;height:auto\" role=\"img\">\n<title>" +
           escape_html(title) + "</title>\n<text x=\"70.0\" y=\"22.0\" font-size=\"15\"" +
           attribute("fill", kSvgInk) + ">" + escape_html(title) + "</text>\n" + std::string(drawn) +
           "</svg>\n";
}

std::string standalone_svg(std::string_view svg) {
    constexpr std::string_view kVariable = "var(--";
    std::string result;
    for (std::size_t at = svg.find(kVariable); at != svg.npos; at = svg.find(kVariable)) {
        const std::size_t comma = svg.find(',', at), close = svg.find(')', at);
        result += svg.substr(0, at);
        const std::string_view light = svg.substr(comma + 1, close - comma - 1);
        result += light.substr(light.find_first_not_of(' '));
        svg.remove_prefix(close + 1);
    }
    result += svg;
    return result;
}

std::string with_words(std::string_view svg,
                       const std::function<std::string(const std::string&)>& translated) {
    constexpr std::string_view kClose = "</text>";
    std::string result;
    for (std::size_t close = svg.find(kClose); close != svg.npos; close = svg.find(kClose)) {
        const std::size_t open = svg.rfind('>', close - 1) + 1;
        result += svg.substr(0, open);
        result += escape_html(translated(unescape_html(svg.substr(open, close - open))));
        result += kClose;
        svg.remove_prefix(close + kClose.size());
    }
    result += svg;
    return result;
}

std::string_view series_colour(std::size_t index) {
    static constexpr std::array<std::string_view, 14> kColours = {
        "var(--series-0, #0072b2)",  "var(--series-1, #d55e00)",  "var(--series-2, #009e73)",
        "var(--series-3, #cc79a7)",  "var(--series-4, #332288)",  "var(--series-5, #e69f00)",
        "var(--series-6, #56b4e9)",  "var(--series-7, #7f3c8d)",  "var(--series-8, #8c564b)",
        "var(--series-9, #8a8a00)",  "var(--series-10, #4d4d4d)", "var(--series-11, #e31a1c)",
        "var(--series-12, #8dd35f)", "var(--series-13, #b39ddb)"};
    return kColours[index % kColours.size()];
}

std::string svg_legend(SvgPoint top, const std::vector<LegendEntry>& entries) {
    std::string svg;
    SvgPoint at = top;
    for (const LegendEntry& entry : entries) {
        svg += "<g data-name=\"" + escape_html(entry.name) + "\">\n";
        svg += entry.ring ? svg_ring({at.x + 5, at.y}, 5, entry.colour)
                          : svg_box({at.x, at.y - 5}, {at.x + 10, at.y + 5}, entry.colour, entry.name);
        svg += svg_text({at.x + 17, at.y + 4}, entry.name) + "</g>\n";
        at.y += kLegendLine;
    }
    return svg;
}

}  // namespace crevice
