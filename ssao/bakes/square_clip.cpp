#include "ssao/bakes/square_clip.h"

namespace crevice {

namespace {

// A triangle cut by four lines has at most seven corners. Where rounding has put corners out of line, a cut
// can leave n / 2 of n corners and add two crossings for each: from 3 to 4, 6, 9, 12.
struct Polygon {
    std::array<glm::dvec2, 12> corners;
    std::size_t count = 0;

    void add(glm::dvec2 corner) { corners[count++] = corner; }
};

// The part where sign * (p[axis] - limit) >= 0. Empty when only an edge or a corner lies there.
Polygon cut(const Polygon& polygon, int axis, double limit, double sign) {
    const auto inside = [&](glm::dvec2 p) { return sign * (p[axis] - limit); };
    Polygon rest;
    bool any_inside = false;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec2 from = polygon.corners[i], to = polygon.corners[(i + 1) % polygon.count];
        const double at_from = inside(from), at_to = inside(to);
        any_inside = any_inside || at_from > 0;
        if (at_from >= 0) rest.add(from);
        if ((at_from > 0 && at_to < 0) || (at_from < 0 && at_to > 0)) {
            glm::dvec2 crossing = from + at_from / (at_from - at_to) * (to - from);
            crossing[axis] = limit;
            rest.add(crossing);
        }
    }
    return any_inside ? rest : Polygon{};
}

}  // namespace

std::optional<glm::dvec2> middle_in_square(const std::array<glm::dvec2, 3>& triangle, glm::dvec2 low) {
    Polygon polygon;
    for (const glm::dvec2& corner : triangle) polygon.add(corner);
    for (int axis = 0; axis < 2; ++axis) {
        polygon = cut(polygon, axis, low[axis], 1);
        polygon = cut(polygon, axis, low[axis] + 1, -1);
    }
    if (polygon.count == 0) return std::nullopt;
    glm::dvec2 sum(0);
    for (std::size_t i = 0; i < polygon.count; ++i) sum += polygon.corners[i];
    return sum / double(polygon.count);
}

}  // namespace crevice
