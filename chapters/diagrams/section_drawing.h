// A drawing in a plane that contains the viewing direction: view z to the right, the eye somewhere on the left, the
// plane's other direction ("across") upwards. Everything is given in scene units. The colours mean the same in every
// diagram of the book: the surface is ink, what is open blue, what is occluded red, the point and its normal green.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/svg.h"

namespace crevice {

struct SectionPoint {
    double z = 0, across = 0;  // scene units
};

class SectionDrawing {
 public:
    // Shows z and across from `low` to `high`, one scale for both.
    SectionDrawing(SectionPoint low, SectionPoint high);

    // A surface seen from the left, as a line; what lies behind it is hatched, for nobody knows what is there. Points at
    // infinite z break the line.
    void surface(const std::vector<SectionPoint>& points);
    void segment(SectionPoint from, SectionPoint to, std::string_view colour, bool dashed = false);
    void arrow(SectionPoint from, SectionPoint to, std::string_view colour);
    void circle(SectionPoint centre, double radius, std::string_view colour);
    // A line through points, such as an arc.
    void path(const std::vector<SectionPoint>& points, std::string_view colour);
    // A faintly filled polygon.
    void area(const std::vector<SectionPoint>& corners, std::string_view colour);
    // A filled dot, or a ring, with a label beside it in the type of formulas; "q_1" has an index.
    enum class Dot { filled, ring };
    void point(SectionPoint at, const std::string& label, std::string_view colour, Dot dot = Dot::filled);
    // A label `dx`, `dy` SVG units off a place, y downwards.
    void label(SectionPoint at, double dx, double dy, const std::string& text, std::string_view colour);
    // Words, not symbols.
    void words(SectionPoint at, double dx, double dy, const std::string& text);

    // The whole picture, with the axes z and `across` marked in the lower left corner.
    std::string svg(const std::string& title, const std::string& across = "y") const;

 private:
    SvgPoint at(SectionPoint p) const;

    SectionPoint low_, high_;
    double scale_;  // SVG units a scene unit
    std::string hatching_, drawn_;
};

}  // namespace crevice
