#include "rasterizer/obj/outline_crossing.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>

#include <glm/common.hpp>

namespace crevice {
namespace {

// Up to here looking at pairs is fast enough, a millisecond where all overlap.
constexpr std::size_t kFewEdges = 1024;

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

bool any_pair_crosses(std::vector<OutlineEdge> edges) {
    std::stable_sort(edges.begin(), edges.end(),
                     [](const OutlineEdge& e, const OutlineEdge& f) { return e.low.x < f.low.x; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size() && edges[j].low.x <= edges[i].high.x; ++j) {
            if (cross(edges[i], edges[j])) return true;
        }
    }
    return false;
}

// Left to right, and upwards where there is no difference: an order of places that leaves no edge vertical.
bool is_before(glm::dvec2 p, glm::dvec2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

// The edges that a line sweeping over the plane meets, from the lowest up (Shamos & Hoey 1976, "Geometric intersection
// problems"). Two that cross are neighbours before the line comes to where the first ones do, so only neighbours are looked
// at. Those that only touch have an order, too: that of where they part.
class Sweep {
 public:
    // Each edge from its earlier end, `a`, to its later one.
    explicit Sweep(const std::vector<OutlineEdge>& edges)
        : edges_(edges), met_(Below{edges}), place_(edges.size(), met_.end()) {}

    // Whether the edge that begins crosses a neighbour.
    bool begins(std::uint32_t edge) {
        const auto [at, is_new] = met_.insert(edge);
        place_[edge] = at;
        const bool below = at != met_.begin() && cross(edges_[*std::prev(at)], edges_[edge]);
        return below || (std::next(at) != met_.end() && cross(edges_[edge], edges_[*std::next(at)]));
    }
    // Whether those that become neighbours when the edge ends cross.
    bool ends(std::uint32_t edge) {
        const auto next = met_.erase(place_[edge]);
        return next != met_.begin() && next != met_.end() && cross(edges_[*std::prev(next)], edges_[*next]);
    }

 private:
    // Whether e lies below f where the line meets both first: at the beginning of the later one.
    struct Below {
        const std::vector<OutlineEdge>& edges;
        bool operator()(std::uint32_t e, std::uint32_t f) const {
            const OutlineEdge &x = edges[e], &y = edges[f];
            const bool x_is_later = is_before(y.a, x.a);
            const OutlineEdge &earlier = x_is_later ? y : x, &later = x_is_later ? x : y;
            double side = area2(earlier.a, earlier.b, later.a);
            if (side == 0) side = area2(earlier.a, earlier.b, later.b);
            if (side == 0) return e < f;
            return x_is_later ? side < 0 : side > 0;
        }
    };

    const std::vector<OutlineEdge>& edges_;
    std::set<std::uint32_t, Below> met_;
    std::vector<std::set<std::uint32_t, Below>::iterator> place_;
};

bool sweep_finds_crossing(std::vector<OutlineEdge> edges) {
    struct Event {
        glm::dvec2 at;
        bool begins;
        std::uint32_t edge;
    };
    std::vector<Event> events;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        if (is_before(edges[i].b, edges[i].a)) std::swap(edges[i].a, edges[i].b);
        events.push_back({edges[i].a, true, i});
        events.push_back({edges[i].b, false, i});
    }
    // At one place edges end before others begin.
    std::stable_sort(events.begin(), events.end(), [](const Event& e, const Event& f) {
        return e.at == f.at ? e.begins < f.begins : is_before(e.at, f.at);
    });
    Sweep sweep(edges);
    return std::any_of(events.begin(), events.end(), [&](const Event& event) {
        return event.begins ? sweep.begins(event.edge) : sweep.ends(event.edge);
    });
}

}  // namespace

bool outline_crosses_itself(const std::vector<glm::dvec2>& points,
                            const std::vector<std::uint32_t>& outline) {
    std::vector<OutlineEdge> edges;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = points[outline[i]], b = points[outline[i + 1 == outline.size() ? 0 : i + 1]];
        if (a != b) edges.push_back({a, b, glm::min(a, b), glm::max(a, b)});
    }
    return edges.size() <= kFewEdges ? any_pair_crosses(std::move(edges))
                                     : sweep_finds_crossing(std::move(edges));
}

}  // namespace crevice
