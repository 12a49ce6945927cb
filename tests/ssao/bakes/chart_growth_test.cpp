// Charts laid flat: every triangle once, none flipped, folded or on top of another.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/shapes.h"
#include "ssao/bakes/chart_growth.h"
#include "ssao/bakes/flat_cells.h"
#include "tests/tools/ray_checks.h"

using namespace crevice;

namespace {

std::vector<WeldedTriangle> welded(const Mesh& mesh) {
    std::vector<WeldedTriangle> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
        const glm::dvec3 face = glm::cross(q - p, r - p);
        triangles.push_back({{p, q, r}, {a, b, c}, glm::normalize(face), glm::length(face) / 2});
    }
    return triangles;
}

// A ramp around the y axis: `turns` turns of `steps` quads, rising 1 a turn.
Mesh spiral_ramp(int turns, int steps) {
    Mesh mesh;
    for (int i = 0; i <= turns * steps; ++i) {
        const SineCosine at = sine_cosine(2 * kPi * i / steps);
        const double y = double(i) / steps;
        mesh.positions.emplace_back(4 * at.cosine, y, 4 * at.sine);
        mesh.positions.emplace_back(6 * at.cosine, y, 6 * at.sine);
        if (i == 0) continue;
        const auto k = static_cast<std::uint32_t>(2 * i);
        mesh.triangles.push_back({k - 2, k, k - 1});
        mesh.triangles.push_back({k - 1, k, k + 1});
    }
    return mesh;
}

// How many pairs of triangles of one chart overlap, every pair tried; a point of both insides settles it.
int overlapping_pairs(const FlatChart& chart) {
    int pairs = 0;
    for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            pairs += overlap(chart.triangles[i].corners, chart.triangles[k].corners, 1e-5) ? 1 : 0;
    }
    return pairs;
}

// That each triangle is in one chart, within the chart's rectangle, not flipped and not shrunk by more than
// cos 60 degrees.
void check_charts(const std::vector<WeldedTriangle>& triangles, const std::vector<FlatChart>& charts) {
    std::vector<int> times(triangles.size(), 0);
    for (std::size_t i = 0; i < charts.size(); ++i) {
        CAPTURE(i);
        CHECK(charts[i].extent.x >= charts[i].extent.y);
        glm::dvec2 high(0);
        for (const FlatTriangle& t : charts[i].triangles) {
            CAPTURE(t.triangle);
            ++times[t.triangle];
            const double area = cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]) / 2;
            CHECK(area >= 0.5 * triangles[t.triangle].area);
            CHECK(area <= triangles[t.triangle].area * (1 + 1e-9));
            for (const glm::dvec2& p : t.corners) {
                CHECK(std::min(p.x, p.y) >= 0);
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
        }
        CHECK(high.x == doctest::Approx(charts[i].extent.x).epsilon(1e-12));
        CHECK(high.y == doctest::Approx(charts[i].extent.y).epsilon(1e-12));
        CHECK(overlapping_pairs(charts[i]) == 0);
    }
    CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
}

}  // namespace

TEST_CASE("chart growth: a flat grid, turned anyhow, is one chart that keeps its size and lies square") {
    Mesh mesh = grid_mesh(6, 4, 5, 7);
    const SineCosine a = sine_cosine(0.7), b = sine_cosine(1.1);
    for (glm::vec3& p : mesh.positions) {
        const glm::dvec3 q = p;
        const glm::dvec3 r(a.cosine * q.x - a.sine * q.y, a.sine * q.x + a.cosine * q.y, q.z);
        p = glm::vec3(r.x, b.cosine * r.y - b.sine * r.z, b.sine * r.y + b.cosine * r.z);
    }
    const std::vector<WeldedTriangle> triangles = welded(mesh);
    const std::vector<FlatChart> charts = grow_charts(triangles);
    REQUIRE(charts.size() == 1);
    CHECK(charts[0].extent.x == doctest::Approx(6).epsilon(1e-6));
    CHECK(charts[0].extent.y == doctest::Approx(4).epsilon(1e-6));
    for (const FlatTriangle& t : charts[0].triangles) {
        CAPTURE(t.triangle);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const auto& c = triangles[t.triangle].corners;
            CHECK(glm::length(t.corners[next] - t.corners[k]) ==
                  doctest::Approx(glm::length(c[next] - c[k])).epsilon(1e-6));
        }
    }
    check_charts(triangles, charts);
}

TEST_CASE(
    "chart growth: a box is six charts, its edges are too sharp; a 16-sided tube fewer than its sides") {
    const std::vector<WeldedTriangle> box = welded(box_mesh({1, 2, 3}, 3));
    CHECK(grow_charts(box).size() == 6);
    check_charts(box, grow_charts(box));
    const std::vector<WeldedTriangle> tube = welded(cylinder_mesh(1, 1, 4, 16, 3));
    CHECK(grow_charts(tube).size() < 16);
    check_charts(tube, grow_charts(tube));
}

TEST_CASE("chart growth: a sphere: no triangle is flipped or looked at too steeply") {
    const std::vector<WeldedTriangle> sphere = welded(sphere_mesh(2, 40, 30));
    const std::vector<FlatChart> charts = grow_charts(sphere);
    check_charts(sphere, charts);
    for (const FlatChart& chart : charts) {
        const glm::dvec3 first = sphere[chart.triangles[0].triangle].normal;
        for (const FlatTriangle& t : chart.triangles)
            CHECK(glm::dot(first, sphere[t.triangle].normal) >= kConeCosine);
    }
    CHECK(charts.size() < 60);
}

TEST_CASE("chart growth: a spiral ramp is cut where it comes to lie on itself") {
    const int turns = 3;
    const std::vector<WeldedTriangle> ramp = welded(spiral_ramp(turns, 24));
    const std::vector<FlatChart> charts = grow_charts(ramp);
    check_charts(ramp, charts);
    CHECK(charts.size() >= turns);
    CHECK(charts.size() <= 2 * turns);
}

TEST_CASE("chart growth: surfaces that lie on one another go to charts of their own") {
    Mesh twice = grid_mesh(2, 1, 3, 3);
    const auto once = twice.triangles;
    twice.triangles.insert(twice.triangles.end(), once.begin(), once.end());
    const std::vector<WeldedTriangle> triangles = welded(twice);
    CHECK(grow_charts(triangles).size() == 2);
    check_charts(triangles, grow_charts(triangles));
    CHECK(grow_charts({}).empty());
}

TEST_CASE("chart growth: an edge that four triangles share holds together only what faces alike") {
    // A floor cut by a wall that stands on its middle edge.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 4}, {-3, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, -3, 0}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}};
    const std::vector<WeldedTriangle> triangles = welded(mesh);
    const std::vector<FlatChart> charts = grow_charts(triangles);
    CHECK(charts.size() == 2);
    check_charts(triangles, charts);
}

TEST_CASE("overlap: insides count, shared edges and corners do not") {
    const FlatCorners a = {glm::dvec2(0, 0), {4, 0}, {0, 4}};
    const auto moved = [](FlatCorners t, glm::dvec2 by) {
        for (glm::dvec2& p : t) p += by;
        return t;
    };
    CHECK(overlap(a, a, 0));
    CHECK(overlap(a, moved(a, {1, 1}), 0));
    CHECK(overlap(a, {glm::dvec2(1, 1), {1.5, 1}, {1, 1.5}}, 0));
    CHECK(overlap({glm::dvec2(1, 1), {1.5, 1}, {1, 1.5}}, a, 0));
    CHECK(overlap(a, {glm::dvec2(-1, 1), {9, 1}, {9, 1.01}}, 0));
    CHECK(!overlap(a, {glm::dvec2(4, 0), {4, 4}, {0, 4}}, 0));
    CHECK(!overlap(a, {glm::dvec2(0, 0), {0, -3}, {3, -3}}, 0));
    CHECK(!overlap(a, moved(a, {4, 0}), 0));
    CHECK(!overlap(a, moved(a, {3, 3}), 0));
    CHECK(overlap(a, moved(a, {3.99, 0}), 1e-3));
    CHECK(!overlap(a, moved(a, {3.99, 0}), 0.02));
}

TEST_CASE("flat cells: the same decisions as against all triangles") {
    for (const float size : {0.02f, 0.2f, 2.0f}) {
        RandomNumbers random(7);
        std::vector<FlatCorners> all;
        while (all.size() < 400) {
            const glm::vec3 at = random.in_cube(1), a = random.in_cube(size), b = random.in_cube(size);
            FlatCorners t = {glm::dvec2(at), glm::dvec2(at + a), glm::dvec2(at + b)};
            if (cross(t[1] - t[0], t[2] - t[0]) < 0) std::swap(t[1], t[2]);
            all.push_back(t);
        }
        FlatCells cells(all);
        std::vector<FlatCorners> accepted;
        int wrong = 0;
        for (const FlatCorners& t : all) {
            const bool free = std::none_of(accepted.begin(), accepted.end(), [&](const FlatCorners& other) {
                return overlap(t, other, 1e-6 * 2.8 * (1 + size));
            });
            const bool added = cells.add_unless_overlapping(t);
            wrong += added != free ? 1 : 0;
            if (added) accepted.push_back(t);
        }
        CAPTURE(size);
        CHECK(wrong == 0);
        CHECK(accepted.size() < all.size());
    }
}
