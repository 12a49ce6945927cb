#include "ssao/bakes/chart_growth.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ssao/bakes/flat_cells.h"

namespace crevice {

namespace {

// An edge of a triangle; those with equal ends are next to each other.
struct SharedEdge {
    std::uint32_t low, high;  // points, low < high
    std::uint32_t triangle, side;
};

// Which triangles share which edges.
class EdgeTable {
 public:
    explicit EdgeTable(std::span<const WeldedTriangle> triangles) : first_(3 * triangles.size()) {
        edges_.reserve(3 * triangles.size());
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            const auto& p = triangles[i].points;
            for (std::uint32_t side = 0; side < 3; ++side) {
                const std::uint32_t a = p[side], b = p[(side + 1) % 3];
                edges_.push_back({std::min(a, b), std::max(a, b), i, side});
            }
        }
        std::sort(edges_.begin(), edges_.end(), [](const SharedEdge& a, const SharedEdge& b) {
            return std::tie(a.low, a.high, a.triangle, a.side) < std::tie(b.low, b.high, b.triangle, b.side);
        });
        std::uint32_t first = 0;
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            if (edges_[i].low != edges_[first].low || edges_[i].high != edges_[first].high) first = i;
            first_[3 * edges_[i].triangle + edges_[i].side] = first;
        }
    }

    // Calls body(triangle) for each triangle with that edge, itself included.
    template <class Body>
    void for_sharing(std::uint32_t triangle, std::uint32_t side, const Body& body) const {
        const std::uint32_t first = first_[3 * triangle + side];
        for (std::uint32_t i = first; i < edges_.size(); ++i) {
            if (edges_[i].low != edges_[first].low || edges_[i].high != edges_[first].high) return;
            body(edges_[i].triangle);
        }
    }

 private:
    std::vector<SharedEdge> edges_;
    std::vector<std::uint32_t> first_;  // of each triangle's sides, the first equal edge
};

// Two axes of the plane that a chart is laid on.
struct FlatAxes {
    glm::dvec3 origin, u, v;

    glm::dvec2 of(const glm::dvec3& p) const { return {glm::dot(p - origin, u), glm::dot(p - origin, v)}; }
};

class ChartGrower {
 public:
    explicit ChartGrower(std::span<const WeldedTriangle> triangles)
        : triangles_(triangles), edges_(triangles), stamp_(triangles.size(), kFree) {}

    std::vector<FlatChart> charts() {
        std::vector<FlatChart> charts;
        for (std::uint32_t seed = 0; seed < triangles_.size(); ++seed) {
            if (stamp_[seed] != kLaid) charts.push_back(chart_from(seed));
        }
        return charts;
    }

 private:
    // What a triangle has been through; other values are the number of the walk that reached it last.
    static constexpr std::uint32_t kFree = 0, kLaid = 1;

    // The triangles that can be reached from `seed` over edges, in the order in which they are reached: from
    // each only those of its neighbours that accept() takes.
    template <class Accept>
    std::vector<std::uint32_t> walk(std::uint32_t seed, const Accept& accept) {
        ++walk_;
        std::vector<std::uint32_t> reached = {seed};
        stamp_[seed] = walk_;
        for (std::size_t i = 0; i < reached.size(); ++i) {
            for (std::uint32_t side = 0; side < 3; ++side) {
                edges_.for_sharing(reached[i], side, [&](std::uint32_t next) {
                    if (stamp_[next] == kLaid || stamp_[next] == walk_ || !accept(next)) return;
                    stamp_[next] = walk_;
                    reached.push_back(next);
                });
            }
        }
        return reached;
    }

    // Only for a group that walk() has just reached.
    FlatAxes axes_of(const std::vector<std::uint32_t>& group) const {
        glm::dvec3 sum(0);
        for (const std::uint32_t t : group) sum += triangles_[t].area * triangles_[t].normal;
        const glm::dvec3 axis = glm::normalize(sum);
        const auto flat_side = [&](std::uint32_t t, std::uint32_t side) {
            const glm::dvec3 edge = triangles_[t].corners[(side + 1) % 3] - triangles_[t].corners[side];
            return edge - glm::dot(edge, axis) * axis;
        };
        const auto on_rim = [&](std::uint32_t t, std::uint32_t side) {
            bool inner = false;
            edges_.for_sharing(t, side, [&](std::uint32_t other) {
                inner = inner || (other != t && stamp_[other] == walk_);
            });
            return !inner;
        };
        // Along the longest edge of the rim, so that rectangles come to lie square. Where everything is there
        // twice there is no rim.
        glm::dvec3 along = flat_side(group.front(), 0);
        double longest = 0;
        for (const std::uint32_t t : group) {
            for (std::uint32_t side = 0; side < 3; ++side) {
                const glm::dvec3 edge = flat_side(t, side);
                const double squared = glm::dot(edge, edge);
                if (squared <= longest || !on_rim(t, side)) continue;
                longest = squared;
                along = edge;
            }
        }
        const glm::dvec3 u = glm::normalize(along);
        return {triangles_[group.front()].corners[0], u, glm::cross(axis, u)};
    }

    FlatChart chart_from(std::uint32_t seed) {
        const glm::dvec3 n = triangles_[seed].normal;
        const std::vector<std::uint32_t> group = walk(
            seed, [&](std::uint32_t next) { return glm::dot(triangles_[next].normal, n) >= kConeCosine; });
        const FlatAxes axes = axes_of(group);
        const auto flat = [&](std::uint32_t t) {
            const auto& c = triangles_[t].corners;
            return FlatCorners{axes.of(c[0]), axes.of(c[1]), axes.of(c[2])};
        };
        std::vector<FlatCorners> all;
        for (const std::uint32_t t : group) all.push_back(flat(t));
        FlatCells laid(all);
        laid.add(all.front());
        const std::uint32_t group_walk = walk_;
        // The second walk stays within the group: its triangles carry the first walk's number until reached.
        const std::vector<std::uint32_t> chosen = walk(seed, [&](std::uint32_t next) {
            return stamp_[next] == group_walk && laid.add_unless_overlapping(flat(next));
        });
        FlatChart chart;
        for (const std::uint32_t t : chosen) {
            stamp_[t] = kLaid;
            chart.triangles.push_back({t, flat(t)});
        }
        set_upright(chart);
        return chart;
    }

    // Moves the chart's corner to the origin and turns its longer side to x.
    static void set_upright(FlatChart& chart) {
        glm::dvec2 low = chart.triangles.front().corners[0], high = low;
        for (const FlatTriangle& t : chart.triangles) {
            for (const glm::dvec2& p : t.corners) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
        }
        chart.extent = high - low;
        const bool turn = chart.extent.y > chart.extent.x;
        for (FlatTriangle& t : chart.triangles) {
            for (glm::dvec2& p : t.corners) p = turn ? glm::dvec2(p.y - low.y, high.x - p.x) : p - low;
        }
        if (turn) std::swap(chart.extent.x, chart.extent.y);
    }

    std::span<const WeldedTriangle> triangles_;
    EdgeTable edges_;
    std::vector<std::uint32_t> stamp_;
    std::uint32_t walk_ = kLaid;
};

}  // namespace

std::vector<FlatChart> grow_charts(std::span<const WeldedTriangle> triangles) {
    return ChartGrower(triangles).charts();
}

}  // namespace crevice
