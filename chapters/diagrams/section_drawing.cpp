#include "chapters/diagrams/section_drawing.h"

#include <algorithm>
#include <cmath>

#include "chapters/notebook/html.h"
#include "chapters/notebook/translation.h"

namespace crevice {

namespace {

constexpr double kLargest = 560, kSectionDrawingTop = 34,
                 kMargin = 8;      // of the drawn part and around it, SVG units
constexpr double kBehind = 10000;  // further than any drawing reaches, SVG units

// A symbol with its index: q_1 as q and a lowered 1.
std::string symbol(const std::string& label) {
    const std::size_t index = label.find('_');
    std::string svg = escape_html(label.substr(0, index));
    if (index != label.npos)
        svg += "<tspan dy=\"4\" font-size=\"11\">" + escape_html(label.substr(index + 1)) + "</tspan>";
    return svg;
}

// Symbols are set as mathematics; words are not, for slanted Chinese is no typeface.
std::string symbol_text(SvgPoint at, const std::string& label, std::string_view colour) {
    constexpr std::size_t kLongestSymbol = 3;
    const bool is_symbol = std::min(label.find('_'), label.size()) <= kLongestSymbol;
    return "<text x=\"" + svg_number(at.x) + "\" y=\"" + svg_number(at.y) + "\" fill=\"" +
           std::string(colour) +
           (is_symbol ? "\" font-family=\"KaTeX_Math, 'Latin Modern Math', serif\" font-style=\"italic\" "
                        "font-size=\"17"
                      : "\" font-size=\"13") +
           "\" paint-order=\"stroke\" stroke-width=\"4\" stroke=\"" + std::string(kSvgPaper) + "\">" +
           symbol(label) + "</text>\n";
}

}  // namespace

SectionDrawing::SectionDrawing(SectionPoint low, SectionPoint high)
    : low_(low), high_(high), scale_(kLargest / std::max(high.z - low.z, high.across - low.across)) {}

SvgPoint SectionDrawing::at(SectionPoint p) const {
    return {kMargin + (p.z - low_.z) * scale_, kSectionDrawingTop + (high_.across - p.across) * scale_};
}

void SectionDrawing::surface(const std::vector<SectionPoint>& points) {
    std::vector<SvgPoint> line;
    const auto end_line = [&] {
        if (line.size() > 1) {
            drawn_ += svg_polyline(line, kSvgInk, " stroke-width=\"2.5\"");
            line.push_back({kBehind, line.back().y});
            line.insert(line.begin(), SvgPoint{kBehind, line.front().y});
            hatching_ += "<polygon points=\"";
            for (const SvgPoint& p : line) hatching_ += svg_number(p.x) + "," + svg_number(p.y) + " ";
            hatching_ += "\"/>\n";
        }
        line.clear();
    };
    for (const SectionPoint& p : points) {
        if (std::isfinite(p.z)) {
            line.push_back(at(p));
        } else {
            end_line();
        }
    }
    end_line();
}

void SectionDrawing::segment(SectionPoint from, SectionPoint to, std::string_view colour, bool dashed) {
    if (!std::isfinite(from.z) || !std::isfinite(to.z)) return;  // one of the ends is the sky
    drawn_ += svg_polyline({at(from), at(to)}, colour, dashed ? " stroke-dasharray=\"5 4\"" : "");
}

void SectionDrawing::arrow(SectionPoint from, SectionPoint to, std::string_view colour) {
    constexpr double kHead = 9, kHalfWidth = 0.45;  // SVG units; of the head's length
    const SvgPoint a = at(from), b = at(to);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < kHead) return;
    const double x = (b.x - a.x) / length * kHead, y = (b.y - a.y) / length * kHead;
    drawn_ += svg_polyline({a, {b.x - x, b.y - y}}, colour, " stroke-width=\"2\"");
    drawn_ += "<polygon fill=\"" + std::string(colour) + "\" points=\"" + svg_number(b.x) + "," +
              svg_number(b.y) + " " + svg_number(b.x - x - kHalfWidth * y) + "," +
              svg_number(b.y - y + kHalfWidth * x) + " " + svg_number(b.x - x + kHalfWidth * y) + "," +
              svg_number(b.y - y - kHalfWidth * x) + "\"/>\n";
}

void SectionDrawing::circle(SectionPoint centre, double radius, std::string_view colour) {
    drawn_ += "<circle cx=\"" + svg_number(at(centre).x) + "\" cy=\"" + svg_number(at(centre).y) + "\" r=\"" +
              svg_number(radius * scale_) + "\" fill=\"none\" stroke=\"" + std::string(colour) +
              "\" stroke-dasharray=\"3 4\"/>\n";
}

void SectionDrawing::path(const std::vector<SectionPoint>& points, std::string_view colour) {
    std::vector<SvgPoint> line;
    for (const SectionPoint& p : points) line.push_back(at(p));
    drawn_ += svg_polyline(line, colour);
}

void SectionDrawing::area(const std::vector<SectionPoint>& corners, std::string_view colour) {
    drawn_ += "<polygon fill=\"" + std::string(colour) + "\" fill-opacity=\"0.22\" points=\"";
    for (const SectionPoint& p : corners) drawn_ += svg_number(at(p).x) + "," + svg_number(at(p).y) + " ";
    drawn_ += "\"/>\n";
}

void SectionDrawing::point(SectionPoint p, const std::string& name, std::string_view colour, Dot dot) {
    drawn_ += dot == Dot::filled ? svg_dot(at(p), 4.5, colour) : svg_ring(at(p), 4.5, colour);
    if (!name.empty()) label(p, 8, -8, name, colour);
}

void SectionDrawing::label(SectionPoint p, double dx, double dy, const std::string& text,
                           std::string_view colour) {
    drawn_ += symbol_text({at(p).x + dx, at(p).y + dy}, text, colour);
}

void SectionDrawing::words(SectionPoint p, double dx, double dy, const std::string& text) {
    drawn_ += svg_text({at(p).x + dx, at(p).y + dy}, text, TextAnchor::start, kSvgSoft);
}

std::string SectionDrawing::svg(const std::string& title, const std::string& across) const {
    const double width = (high_.z - low_.z) * scale_, height = (high_.across - low_.across) * scale_;
    const std::string box = "x=\"" + svg_number(kMargin) + "\" y=\"" + svg_number(kSectionDrawingTop) +
                            "\" width=\"" + svg_number(width) + "\" height=\"" + svg_number(height) + "\"";
    // Several drawings share a page: what is named in one must not be found in another.
    const std::string id = text_hash(title + drawn_);
    std::string body = "<defs><clipPath id=\"frame-" + id + "\"><rect " + box +
                       "/></clipPath><pattern id=\"behind-" + id +
                       "\" width=\"9\" height=\"9\" patternUnits=\"userSpaceOnUse\" "
                       "patternTransform=\"rotate(45)\"><line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"9\" stroke=\"" +
                       std::string(kSvgGrid) + "\" stroke-width=\"2\"/></pattern></defs>\n";
    body += "<g clip-path=\"url(#frame-" + id + ")\">\n<g fill=\"url(#behind-" + id + ")\">" + hatching_ +
            "</g>\n" + drawn_ + "</g>\n<rect " + box + " fill=\"none\" stroke=\"" + std::string(kSvgGrid) +
            "\"/>\n";
    const SvgPoint corner = {kMargin + 14, kSectionDrawingTop + height - 14};
    body += svg_line(corner, {corner.x + 34, corner.y}, kSvgSoft) +
            svg_line(corner, {corner.x, corner.y - 34}, kSvgSoft) +
            symbol_text({corner.x + 38, corner.y + 4}, "z", kSvgSoft) +
            symbol_text({corner.x - 4, corner.y - 40}, across, kSvgSoft);
    return svg_picture(title, width + 2 * kMargin, height + kSectionDrawingTop + kMargin, body);
}

}  // namespace crevice
