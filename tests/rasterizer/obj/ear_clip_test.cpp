#include "rasterizer/obj/ear_clip.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "rasterizer/obj/outline_crossing.h"
#include "tests/tools/random_outline.h"

using namespace crevice;

namespace {

using Polygon = std::vector<glm::vec3>;

Polygon flat_polygon(const std::vector<glm::ivec2>& outline) {
    Polygon polygon;
    for (const glm::ivec2 p : outline) polygon.emplace_back(p.x, p.y, 0);
    return polygon;
}

Polygon rotated(Polygon polygon, std::size_t start) {
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(start), polygon.end());
    return polygon;
}

Polygon moved(Polygon polygon, float scale, glm::vec3 shift) {
    for (glm::vec3& p : polygon) p = scale * p + shift;
    return polygon;
}

std::string described(const Polygon& polygon) {
    std::string text;
    for (const glm::vec3& p : polygon) {
        text += "(" + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + ") ";
    }
    return text;
}

// Twice the area vector of a triangle of corners.
glm::dvec3 area2(const Polygon& polygon, const std::array<std::uint32_t, 3>& t) {
    const glm::dvec3 a = polygon[t[0]], b = polygon[t[1]], c = polygon[t[2]];
    return glm::cross(b - a, c - a);
}

// What makes a triangulation one: its edges are the outline's, each in its own direction, and others in
// opposed pairs; all triangles face the polygon's way. Their areas then cover the inside exactly once.
void check_triangulates(const Polygon& polygon, std::size_t triangles_expected) {
    INFO("polygon " << described(polygon));
    const Triangulation cut = ear_clip(polygon);
    CHECK_FALSE(cut.self_intersecting);
    CHECK(cut.triangles.size() == triangles_expected);
    const glm::dvec3 whole = newell_normal(polygon);
    const double length = glm::length(whole);
    REQUIRE(length > 0);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double sum = 0;
    for (const auto& t : cut.triangles) {
        CAPTURE(t[0]);
        CAPTURE(t[1]);
        CAPTURE(t[2]);
        const double facing = glm::dot(area2(polygon, t), whole / length);
        CHECK(facing > 0);
        sum += facing;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = t[k], to = t[(k + 1) % 3];
            from < to ? ++edges[{from, to}] : --edges[{to, from}];
        }
    }
    CHECK(std::abs(sum - length) <= 1e-12 * length);
    const auto count = static_cast<std::uint32_t>(polygon.size());
    for (const auto& [edge, times] : edges) {
        const bool forward = edge.second == edge.first + 1;
        const bool closing = edge.first == 0 && edge.second == count - 1;
        CHECK(times == (forward ? 1 : closing ? -1 : 0));
    }
}

// The same polygon from every start, at several places and scales.
void check_everywhere(const Polygon& polygon) {
    for (std::size_t start = 0; start < polygon.size(); ++start) {
        const Polygon from_start = rotated(polygon, start);
        for (const float scale : {1.0f, 0x1p-20f, 0x1p20f, 1e-5f}) {
            check_triangulates(moved(from_start, scale, glm::vec3(0)), polygon.size() - 2);
        }
        for (const glm::vec3 shift : {glm::vec3(-10), glm::vec3(1e6f, -1e6f, 5)}) {
            check_triangulates(moved(from_start, 1, shift), polygon.size() - 2);
        }
    }
}

}  // namespace

TEST_CASE("ear_clip: the concave pentagon that loses its faces elsewhere, at every place, scale and start") {
    const Polygon pentagon = flat_polygon({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
    check_everywhere(pentagon);
    for (std::size_t start = 0; start < 5; ++start) {
        const Polygon here = moved(rotated(pentagon, start), 1, {-10, -10, 0});
        double sum = 0;
        for (const auto& t : ear_clip(here).triangles) sum += area2(here, t).z / 2;
        CAPTURE(start);
        CHECK(sum == 10);
    }
}

TEST_CASE("ear_clip: collinear corners cost no triangle its area") {
    check_everywhere(flat_polygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}}));
    check_everywhere(flat_polygon({{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}}));
    check_everywhere(flat_polygon({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}));
}

TEST_CASE("ear_clip: random simple polygons in planes of every facing") {
    int tried = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        const std::vector<glm::ivec2> outline = random_outline(seed, 4 + seed % 21);
        if (outline.empty()) continue;
        ++tried;
        Polygon polygon;
        for (const glm::ivec2 p : outline) {
            const int tilt = 2 * p.x - 3 * p.y + 7, gentle = p.x + p.y;
            switch (seed % 4) {
                case 0: polygon.emplace_back(p.x, p.y, 0); break;
                case 1: polygon.emplace_back(tilt, p.x, p.y); break;
                case 2: polygon.emplace_back(p.y, tilt, p.x); break;
                default: polygon.emplace_back(p.y, p.x, gentle); break;
            }
        }
        check_triangulates(polygon, polygon.size() - 2);
        check_triangulates(moved(rotated(polygon, seed % polygon.size()), 0x1p-17f, glm::vec3(0)),
                           polygon.size() - 2);
        std::reverse(polygon.begin(), polygon.end());
        check_triangulates(polygon, polygon.size() - 2);
    }
    CHECK(tried > 250);
}

TEST_CASE("ear_clip: holes joined to the outline by a bridge stay open") {
    // A square with a square hole, then with two; the hole runs the other way round, each bridge is gone
    // along twice.
    const std::vector<std::vector<glm::ivec2>> outlines = {
        {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}},
        {{0, 0},
         {20, 0},
         {20, 9},
         {13, 6},
         {16, 6},
         {16, 3},
         {13, 3},
         {13, 6},
         {20, 9},
         {0, 9},
         {3, 6},
         {6, 6},
         {6, 3},
         {3, 3},
         {3, 6},
         {0, 9}},
    };
    const std::array<double, 2> areas = {81 - 9, 180 - 18};
    for (std::size_t which = 0; which < outlines.size(); ++which) {
        for (std::size_t start = 0; start < outlines[which].size(); ++start) {
            CAPTURE(which);
            CAPTURE(start);
            const Polygon polygon = rotated(flat_polygon(outlines[which]), start);
            const Triangulation cut = ear_clip(polygon);
            CHECK_FALSE(cut.self_intersecting);
            double sum = 0;
            for (const auto& t : cut.triangles) {
                CHECK(area2(polygon, t).z >= 0);
                sum += area2(polygon, t).z / 2;
            }
            CHECK(sum == areas[which]);
        }
    }
}

TEST_CASE("ear_clip: repeated corners are passed over") {
    const Polygon polygon =
        flat_polygon({{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {2, 1}, {0, 4}, {0, 0}});
    const Triangulation cut = ear_clip(polygon);
    CHECK_FALSE(cut.self_intersecting);
    double sum = 0;
    for (const auto& t : cut.triangles) sum += area2(polygon, t).z / 2;
    CHECK(sum == 10);
    CHECK(cut.triangles.size() == 3);
}

TEST_CASE("ear_clip: an outline that crosses itself is said to, and still gives triangles") {
    const std::vector<std::vector<glm::ivec2>> outlines = {
        {{0, 0}, {2, 2}, {2, 0}, {0, 2}},              // bow-tie whose areas cancel
        {{0, 0}, {4, 4}, {4, 0}, {0, 2}},              // bow-tie whose areas do not
        {{0, 9}, {5, -8}, {-9, 3}, {9, 3}, {-5, -8}},  // pentagram: every corner convex
        {{0, 0}, {6, 0}, {6, 6}, {3, -2}, {0, 6}},     // one spike through the opposite edge
    };
    for (const auto& outline : outlines) {
        for (std::size_t start = 0; start < outline.size(); ++start) {
            const Polygon polygon = rotated(flat_polygon(outline), start);
            INFO("polygon " << described(polygon));
            const Triangulation cut = ear_clip(polygon);
            CHECK(cut.self_intersecting);
            CHECK(cut.triangles.size() == outline.size() - 2);
        }
    }
}

TEST_CASE("ear_clip: nothing to cut") {
    CHECK(ear_clip(Polygon{}).triangles.empty());
    CHECK(ear_clip(flat_polygon({{0, 0}, {1, 1}})).triangles.empty());
    CHECK(ear_clip(flat_polygon({{0, 0}, {1, 1}, {2, 2}, {5, 5}, {3, 3}})).triangles.empty());
    CHECK(ear_clip(flat_polygon({{1, 2}, {1, 2}, {1, 2}, {1, 2}, {1, 2}})).triangles.empty());
}

TEST_CASE("ear_clip: a comb with thousands of teeth") {
    std::vector<glm::ivec2> outline = {{0, -1}, {4000, -1}};
    for (int x = 4000; x >= 0; --x) outline.emplace_back(x, x % 2 == 0 ? 0 : 1000);
    check_triangulates(flat_polygon(outline), outline.size() - 2);
}

TEST_CASE("ear_clip: thousands of corners, most of them reflex, all over the inside or along a line") {
    const auto noise = [](std::uint32_t i) { return static_cast<double>(hash_of(i) & 0xffff) / 0x10000; };
    const auto around = [](std::size_t count, const auto& radius_of) {
        Polygon polygon;
        for (std::uint32_t i = 0; i < count; ++i) {
            const double angle = 2 * 3.141592653589793 * i / static_cast<double>(count);
            polygon.emplace_back(radius_of(i) * glm::dvec2(std::cos(angle), std::sin(angle)), 0);
        }
        return polygon;
    };
    check_triangulates(around(2000, [](std::uint32_t) { return 1.0; }), 1998);
    check_triangulates(around(2000, [](std::uint32_t i) { return i % 2 == 0 ? 1.0 : 0.5; }), 1998);
    check_triangulates(around(2000, [&](std::uint32_t i) { return 0.7 + 0.3 * noise(i); }), 1998);
    // Wound clockwise on screen, as files have it as well: only its own normal counts.
    Polygon comb;
    for (int i = 0; i <= 2000; ++i) comb.emplace_back(2000 - i, i % 2 == 0 ? 100 : 3 + i % 3, 0);
    comb.emplace_back(0, 0, 0);
    comb.emplace_back(2000, 0, 0);
    check_triangulates(comb, comb.size() - 2);
    for (glm::vec3& p : comb) p = {p.x - p.y, p.x + p.y, 0};
    check_triangulates(comb, comb.size() - 2);
}

TEST_CASE("outline_crosses_itself: of many edges the sweep says what all pairs say") {
    const auto crosses = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
        const double ac = area2(a, b, c), ad = area2(a, b, d), ca = area2(c, d, a), cb = area2(c, d, b);
        return ((ac > 0 && ad < 0) || (ac < 0 && ad > 0)) && ((ca > 0 && cb < 0) || (ca < 0 && cb > 0));
    };
    int crossing = 0;
    constexpr std::uint32_t kOutlines = 120;
    for (std::uint32_t seed = 0; seed < kOutlines; ++seed) {
        // Whole numbers, so that corners meet, lie on other edges and edges on each other; a few are out of order.
        std::vector<glm::dvec2> points;
        std::vector<std::uint32_t> outline;
        const std::uint32_t count = 1030 + seed;
        const double size = seed % 3 == 0 ? 100 : seed % 3 == 1 ? 1000 : 1e6;
        for (std::uint32_t i = 0; i < count; ++i) {
            const double angle = 2 * 3.141592653589793 * i / count;
            const double radius =
                size * (0.6 + 0.4 * static_cast<double>(hash_of(seed * 5000 + i) & 0xff) / 255);
            points.push_back(glm::round(radius * glm::dvec2(std::cos(angle), std::sin(angle))));
            outline.push_back(i);
        }
        if (seed % 4 == 3) std::swap(outline[seed], outline[seed + 2]);
        bool wanted = false;
        const auto corner = [&](std::uint32_t i) { return points[outline[i % count]]; };
        for (std::uint32_t i = 0; i < count; ++i) {
            for (std::uint32_t j = i + 1; j < count && !wanted; ++j)
                wanted = crosses(corner(i), corner(i + 1), corner(j), corner(j + 1));
        }
        CAPTURE(seed);
        CHECK(outline_crosses_itself(points, outline) == wanted);
        crossing += wanted;
    }
    CHECK(crossing > 20);
    CHECK(crossing < 100);
}

TEST_CASE("quad_cut: convex along the first and third corner, concave along its only inner diagonal") {
    const Polygon convex = flat_polygon({{0, 0}, {4, 0}, {5, 5}, {0, 3}});
    const Polygon dart = flat_polygon({{0, 0}, {1, 10}, {0, 9}, {-1, 10}});  // concave at its third corner
    const Polygon triangle = flat_polygon({{0, 0}, {4, 0}, {4, 4}, {4, 4}});
    for (std::size_t start = 0; start < 4; ++start) {
        CAPTURE(start);
        const auto cut = [&](const Polygon& polygon) {
            const Polygon p = moved(rotated(polygon, start), 1, {-100, -100, 3});
            return quad_cut({p[0], p[1], p[2], p[3]});
        };
        CHECK(cut(convex) == QuadCut::first_third);
        CHECK(cut(dart) == (start % 2 == 0 ? QuadCut::first_third : QuadCut::second_fourth));
        CHECK(cut(triangle) != QuadCut::neither);
    }
    const Polygon bow_tie = flat_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 2}});
    CHECK(quad_cut({bow_tie[0], bow_tie[1], bow_tie[2], bow_tie[3]}) == QuadCut::neither);
}
