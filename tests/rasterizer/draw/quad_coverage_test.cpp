// Quads as two triangles: the rules of dEQP's fill_rules.{basic_quad, basic_quad_reverse, clipped_full,
// clipped_partly, projected} and of piglit's quad-invariance.
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

constexpr Size kSize = {64, 48};

struct Corner {
    glm::dvec2 p_px;
    double w = 1;
};
using Quad = std::array<Corner, 4>;

// The quad as the triangles 0 1 2 and 0 2 3, or along its other diagonal; the second may be wound the other way.
ClipSpaceScene drawn_as(const Quad& quad, bool other_diagonal, bool second_reversed) {
    ClipSpaceScene scene{kSize, {}, {}};
    for (const Corner& corner : quad) scene.add(scene.at_screen(corner.p_px, 0.5, corner.w));
    const std::uint32_t first = other_diagonal ? 1 : 0;
    const auto at = [&](std::uint32_t i) { return (first + i) % 4; };
    scene.triangles = {{at(0), at(1), at(2)}, {at(0), at(2), at(3)}};
    if (second_reversed) std::swap(scene.triangles[1][1], scene.triangles[1][2]);
    return scene;
}

// A square of this half side about the middle of the picture, turned by step * pi / 30.
Quad turned_square(double half_px, int step, glm::dvec2 middle = {32, 24}) {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i) {
        const double angle = kPi / 4 + kPi / 2 * static_cast<double>(i) + step * kPi / 30;
        const double reach = half_px * std::sqrt(2.0);
        quad[i] = {middle + reach * glm::dvec2(std::cos(angle), std::sin(angle))};
    }
    return quad;
}

// How far a pixel's centre lies inside the quad, whose corners go round clockwise on the screen; negative: outside.
double distance_inside(const Quad& quad, int x, int y) {
    double least = 1e30;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 a = quad[i].p_px, edge = quad[(i + 1) % 4].p_px - a;
        const glm::dvec2 to = glm::dvec2(x + 0.5, y + 0.5) - a;
        least = std::min(least, (edge.x * to.y - edge.y * to.x) / std::hypot(edge.x, edge.y));
    }
    return least;
}

// "" when each pixel whose centre lies in the quad is drawn once, and none outside; near the border either.
std::string against(const Quad& quad, const Image<std::int32_t>& count) {
    constexpr double kNear_px = 0.02;
    return pixels_against(kSize, [&](int x, int y) {
        const double inside = distance_inside(quad, x, y);
        const std::int32_t times = count.at(x, y);
        return inside > kNear_px ? times == 1 : (inside < -kNear_px ? times == 0 : times <= 1);
    });
}

}  // namespace

TEST_CASE(
    "quad coverage: basic_quad and its reverse: one fragment a pixel, whichever way each half is wound") {
    for (int step = 0; step < 15; ++step) {
        const Quad quad = turned_square(17.3, step);
        for (const bool other : {false, true}) {
            for (const bool reversed : {false, true}) {
                CAPTURE(step);
                CAPTURE(other);
                CAPTURE(reversed);
                CHECK(against(quad, draw(drawn_as(quad, other, reversed)).count) == "");
            }
        }
    }
}

TEST_CASE(
    "quad coverage: clipped_full: a quad larger than the picture fills it without a hole along its "
    "diagonal") {
    for (const double half_px : {100.0, 3000.0, 200000.0}) {
        for (int step = 0; step < 15; ++step) {
            CAPTURE(half_px);
            CAPTURE(step);
            CHECK(differences(draw(drawn_as(turned_square(half_px, step), false, false)).count, 1) == "");
        }
    }
}

TEST_CASE(
    "quad coverage: clipped_partly: what leaves the picture on any side takes nothing from what stays") {
    for (int step = 0; step < 15; ++step) {
        for (const glm::dvec2 middle : {glm::dvec2(0, 24), {64, 24}, {32, 0}, {32, 48}, {60, 45}}) {
            const Quad quad = turned_square(21.7, step, middle);
            CAPTURE(step);
            CAPTURE(middle.x);
            CAPTURE(middle.y);
            CHECK(against(quad, draw(drawn_as(quad, false, false)).count) == "");
        }
    }
}

TEST_CASE("quad coverage: projected: corners at any w make the same pixels") {
    RandomSequence random(3);
    for (int step = 0; step < 15; ++step) {
        Quad quad = turned_square(19, step);
        for (Corner& corner : quad) corner.w = random.between(0.1, 4);
        CAPTURE(step);
        CHECK(against(quad, draw(drawn_as(quad, false, false)).count) == "");
    }
}

TEST_CASE(
    "quad coverage: quad-invariance: either diagonal of a convex quad covers the same pixels, to the last "
    "one") {
    RandomSequence random(11);
    for (int i = 0; i < 300; ++i) {
        Quad quad = turned_square(random.between(4, 40), 0, {random.between(0, 64), random.between(0, 48)});
        for (Corner& corner : quad) {
            // On the grid of 1/256 pixel, where corners stay when they are snapped; many on pixel centres.
            const double grid = random.whole(0, 1) == 0 ? 2 : 256;
            corner.p_px = glm::floor(corner.p_px * grid) / grid + 0.5;
        }
        const Image<std::int32_t> one = draw(drawn_as(quad, false, false)).count;
        CAPTURE(i);
        CHECK(differences(draw(drawn_as(quad, true, false)).count, one) == "");
    }
}
