// Pieces of SVG that the lab's plots are made of. Coordinates are the picture's own units, x right, y down;
// text is plain and escaped here.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace crevice {

// One decimal: a tenth of a unit is less than anyone sees.
std::string svg_number(double value);

// Colours that go with the page, in the light and in the dark; a picture that stands alone is light. Their meaning is the
// same through the whole book.
inline constexpr std::string_view kSvgInk = "var(--ink, #1f2328)";    // surfaces, text
inline constexpr std::string_view kSvgSoft = "var(--soft, #656d76)";  // what is not the point
inline constexpr std::string_view kSvgGrid = "var(--line, #ddd)";
inline constexpr std::string_view kSvgPaper =
    "var(--paper, #fff)";  // behind labels, so that lines do not cross them
inline constexpr std::string_view kSvgOpen = "var(--open, #0b5cad)";  // rays and samples that meet nothing
inline constexpr std::string_view kSvgOccluded = "var(--occluded, #c4232e)";  // those that are blocked
inline constexpr std::string_view kSvgPoint = "var(--point, #1a7f37)";        // the point and its normal

struct SvgPoint {
    double x = 0, y = 0;
};

std::string svg_line(SvgPoint from, SvgPoint to, std::string_view colour);
// `more` is further attributes, as they are written.
std::string svg_polyline(const std::vector<SvgPoint>& points, std::string_view colour,
                         std::string_view more = "");
std::string svg_dot(SvgPoint centre, double radius, std::string_view colour, std::string_view more = "");
std::string svg_ring(SvgPoint centre, double radius, std::string_view colour);
// `hint` is shown where the pointer rests. Corners in any order.
std::string svg_box(SvgPoint corner, SvgPoint opposite, std::string_view colour, std::string_view hint);

enum class TextAnchor { start, middle, end };
std::string svg_text(SvgPoint at, std::string_view words, TextAnchor anchor = TextAnchor::start,
                     std::string_view colour = kSvgInk);
// Turned to be read from below.
std::string svg_upward_text(SvgPoint middle, std::string_view words);

// The whole picture with its title above.
std::string svg_picture(std::string_view title, double width, double height, std::string_view drawn);

// The picture in its light colours, for where there is no page to take them from.
std::string standalone_svg(std::string_view svg);

// The words of a picture, each <text> without markup inside, replaced by what `translated` makes of them.
std::string with_words(std::string_view svg,
                       const std::function<std::string(const std::string&)>& translated);

// Colours that can be told apart, also by most who cannot tell red from green, and that a dark page makes lighter; they repeat
// after fourteen.
std::string_view series_colour(std::size_t index);

// Names with their colours, one below the other from `top` down.
struct LegendEntry {
    std::string name;
    std::string_view colour;
    bool ring = false;  // an open circle instead of a filled square
};
std::string svg_legend(SvgPoint top, const std::vector<LegendEntry>& entries);

}  // namespace crevice
