#include "rasterizer/obj/outline_crossing.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>

namespace crevice {
namespace {

struct OutlineEdge {
    glm::dvec2 a, b, low, high;
};

// Whether the two cross at a point inside both. Touching is none: bridges to holes touch.
bool cross(const OutlineEdge& e, const OutlineEdge& f) {
    if (e.high.x < f.low.x || f.high.x < e.low.x || e.high.y < f.low.y || f.high.y < e.low.y) return false;
    const double fa = area2(e.a, e.b, f.a), fb = area2(e.a, e.b, f.b);
    const double ea = area2(f.a, f.b, e.a), eb = area2(f.a, f.b, e.b);
    return ((fa > 0 && fb < 0) || (fa < 0 && fb > 0)) && ((ea > 0 && eb < 0) || (ea < 0 && eb > 0));
}

}  // namespace

bool outline_crosses_itself(const std::vector<glm::dvec2>& points,
                            const std::vector<std::uint32_t>& outline) {
    std::vector<OutlineEdge> edges;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = points[outline[i]], b = points[outline[i + 1 == outline.size() ? 0 : i + 1]];
        edges.push_back({a, b, glm::min(a, b), glm::max(a, b)});
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const OutlineEdge& e, const OutlineEdge& f) { return e.low.x < f.low.x; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size() && edges[j].low.x <= edges[i].high.x; ++j) {
            if (cross(edges[i], edges[j])) return true;
        }
    }
    return false;
}

}  // namespace crevice
