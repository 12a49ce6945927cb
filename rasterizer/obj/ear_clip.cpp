#include "rasterizer/obj/ear_clip.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rasterizer/obj/corner_grid.h"
#include "rasterizer/obj/outline_crossing.h"

namespace crevice {
namespace {

// Below this part of the sum of its absolute parts, a polygon's area vector has cancelled out and gives no
// direction.
constexpr double kCancelled = 1e-12;

// Twice the area vector of the triangle of corners 0, i and i + 1.
glm::dvec3 fan_part(std::span<const glm::vec3> corners, std::size_t i) {
    const glm::dvec3 origin = corners[0];
    return glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
}

// A direction along which to look at the polygon (0 when all corners are on one line), and whether its areas
// cancel: the outline then crosses itself.
struct Facing {
    glm::dvec3 normal = glm::dvec3(0);
    bool cancelled = false;
};
Facing facing_of(std::span<const glm::vec3> corners) {
    const glm::dvec3 sum = newell_normal(corners);
    glm::dvec3 largest(0);
    double parts = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec3 part = fan_part(corners, i);
        parts += std::sqrt(glm::dot(part, part));
        if (glm::dot(part, part) > glm::dot(largest, largest)) largest = part;
    }
    const bool cancelled = parts > 0 && std::sqrt(glm::dot(sum, sum)) <= kCancelled * parts;
    return {cancelled ? largest : sum, cancelled};
}

// The two axes that stay when the one along which `normal` is longest is dropped. Coordinates are copied, not
// rotated, so they stay exact. The order makes a polygon counter-clockwise along its normal counter-clockwise
// in the plane.
struct PlaneAxes {
    int first, second;

    glm::dvec2 flattened(const glm::vec3& corner) const { return {corner[first], corner[second]}; }
};
PlaneAxes plane_axes(glm::dvec3 normal) {
    const glm::dvec3 length = glm::abs(normal);
    const int drop = length.z >= length.x && length.z >= length.y ? 2 : length.x >= length.y ? 0 : 1;
    const int first = normal[drop] >= 0 ? (drop + 1) % 3 : (drop + 2) % 3;
    return {first, 3 - drop - first};
}

// The corners without those at the place of the one before them, which span no area.
std::vector<std::uint32_t> distinct_corners(const std::vector<glm::dvec2>& points) {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (kept.empty() || points[i] != points[kept.back()]) kept.push_back(i);
    }
    while (kept.size() > 1 && points[kept.back()] == points[kept.front()]) kept.pop_back();
    return kept;
}

// What may be clipped. Each level is tried only when the one before finds nothing more.
enum class Allow { strict_ears, touching_ears, flat_corners };

struct Reflex {
    glm::dvec2 point;
    std::uint32_t corner;
};

// The outline that is left, as a ring of corners from which ears are clipped.
struct Ring {
    const std::vector<glm::dvec2>& points;
    std::vector<std::uint32_t> before, after;
    std::vector<Reflex> reflex;            // corners that are not strictly convex, in no particular order
    std::vector<std::uint32_t> reflex_at;  // where a corner stands in `reflex`, or kNowhere
    std::optional<CornerGrid> grid;        // the same corners by their places, where they are many
    std::uint32_t first, left;

    static constexpr std::uint32_t kNowhere = ~0u;
    // Up to here looking through a list is faster.
    static constexpr std::uint32_t kFewCorners = 64;

    Ring(const std::vector<glm::dvec2>& all_points, const std::vector<std::uint32_t>& outline)
        : points(all_points),
          before(points.size()),
          after(points.size()),
          reflex_at(points.size(), kNowhere),
          first(outline.front()),
          left(static_cast<std::uint32_t>(outline.size())) {
        std::iota(before.begin(), before.end(), 0u);
        std::iota(after.begin(), after.end(), 0u);
        for (std::uint32_t i = 0; i < left; ++i) {
            const std::uint32_t next = i + 1 == left ? 0 : i + 1;
            after[outline[i]] = outline[next];
            before[outline[next]] = outline[i];
        }
        if (left > kFewCorners) grid.emplace(points);
        for (const std::uint32_t corner : outline) update_reflex(corner);
    }

    double corner_area2(std::uint32_t v) const {
        return area2(points[before[v]], points[v], points[after[v]]);
    }
    bool alive(std::uint32_t v) const { return after[v] != v; }

    void update_reflex(std::uint32_t v) {
        const bool is_reflex = alive(v) && !(corner_area2(v) > 0);
        if (is_reflex == (reflex_at[v] != kNowhere)) return;
        if (is_reflex) {
            reflex_at[v] = static_cast<std::uint32_t>(reflex.size());
            reflex.push_back({points[v], v});
            if (grid) grid->insert(v);
        } else {
            if (grid) grid->remove(v);
            reflex[reflex_at[v]] = reflex.back();
            reflex_at[reflex.back().corner] = reflex_at[v];
            reflex.pop_back();
            reflex_at[v] = kNowhere;
        }
    }

    // No other corner inside the triangle at v; on its rim only when touching is allowed. Only reflex corners
    // need to be looked at. Those that share a place with a corner of the triangle are the other side of a
    // bridge.
    bool is_ear(std::uint32_t v, Allow allow) const {
        const double area = corner_area2(v);
        if (!(area > 0)) return allow == Allow::flat_corners && area == 0;
        const glm::dvec2 a = points[before[v]], b = points[v], c = points[after[v]];
        const glm::dvec2 low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
        const auto is_inside = [&](glm::dvec2 p) {
            if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) return false;
            if (p == a || p == b || p == c) return false;
            const double ab = area2(a, b, p), bc = area2(b, c, p), ca = area2(c, a, p);
            const bool strictly = ab > 0 && bc > 0 && ca > 0;
            const bool touching = ab >= 0 && bc >= 0 && ca >= 0;
            return allow == Allow::strict_ears ? touching : strictly;
        };
        if (grid && grid->cells_around({a, b, c}) < reflex.size())
            return !grid->any_in_triangle({a, b, c}, [&](std::uint32_t p) { return is_inside(points[p]); });
        return std::none_of(reflex.begin(), reflex.end(),
                            [&](const Reflex& r) { return is_inside(r.point); });
    }

    std::array<std::uint32_t, 3> clip(std::uint32_t v) {
        const std::uint32_t a = before[v], c = after[v];
        after[a] = c;
        before[c] = a;
        after[v] = before[v] = v;
        --left;
        for (const std::uint32_t corner : {v, a, c}) update_reflex(corner);
        first = a;
        return {a, v, c};
    }
};

// Clips until three corners are left or nothing more is allowed; appends the triangles.
void clip_ears(Ring& ring, Allow allow, std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::deque<std::uint32_t> waiting;
    std::vector<bool> is_waiting(ring.points.size(), false);
    const auto wait = [&](std::uint32_t v) {
        if (!is_waiting[v]) waiting.push_back(v);
        is_waiting[v] = true;
    };
    // Every second corner first: neighbours clipped one after another would give a fan of slivers.
    const auto count = static_cast<std::uint32_t>(ring.points.size());
    for (const std::uint32_t start : {1u, 0u}) {
        for (std::uint32_t v = start; v < count; v += 2) {
            if (ring.alive(v)) wait(v);
        }
    }
    while (ring.left > 3 && !waiting.empty()) {
        const std::uint32_t v = waiting.front();
        waiting.pop_front();
        is_waiting[v] = false;
        if (!ring.alive(v) || !ring.is_ear(v, allow)) continue;
        const auto triangle = ring.clip(v);
        triangles.push_back(triangle);
        wait(triangle[0]);
        wait(triangle[2]);
    }
}

}  // namespace

glm::dvec3 newell_normal(std::span<const glm::vec3> corners) {
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += fan_part(corners, i);
    return sum;
}

Triangulation ear_clip(std::span<const glm::vec3> corners) {
    Triangulation result;
    if (corners.size() < 3) return result;
    const Facing facing = facing_of(corners);
    if (facing.normal == glm::dvec3(0)) return result;
    const PlaneAxes axes = plane_axes(facing.normal);
    std::vector<glm::dvec2> points;
    points.reserve(corners.size());
    for (const glm::vec3& corner : corners) points.push_back(axes.flattened(corner));

    const std::vector<std::uint32_t> outline = distinct_corners(points);
    result.self_intersecting = facing.cancelled || outline_crosses_itself(points, outline);
    Ring ring(points, outline);
    for (const Allow allow : {Allow::strict_ears, Allow::touching_ears, Allow::flat_corners}) {
        if (ring.left > 3) clip_ears(ring, allow, result.triangles);
    }
    // What no level could clip has no ears, so it is no simple polygon: a fan, to lose nothing.
    if (ring.left > 3 || ring.corner_area2(ring.after[ring.first]) < 0) result.self_intersecting = true;
    while (ring.left >= 3) result.triangles.push_back(ring.clip(ring.after[ring.first]));
    return result;
}

QuadCut quad_cut(const std::array<glm::vec3, 4>& corners) {
    // Quads are often warped, so they are seen along the normal itself; no area still gives exactly 0.
    const glm::dvec3 normal = newell_normal(corners);
    const auto area2_along = [&](std::size_t i, std::size_t j, std::size_t k) {
        return glm::dot(normal, newell_normal(std::array{corners[i], corners[j], corners[k]}));
    };
    const double a012 = area2_along(0, 1, 2), a023 = area2_along(0, 2, 3);
    const double a013 = area2_along(0, 1, 3), a123 = area2_along(1, 2, 3);
    if (a012 > 0 && a023 > 0) return QuadCut::first_third;
    if (a013 > 0 && a123 > 0) return QuadCut::second_fourth;
    // A quad with a repeated corner is a triangle.
    if (a012 >= 0 && a023 >= 0 && a012 + a023 > 0) return QuadCut::first_third;
    return QuadCut::neither;
}

}  // namespace crevice
