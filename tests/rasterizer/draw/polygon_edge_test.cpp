// Edges that cross the picture on their way between corners far outside: the rules of dEQP's
// clipping.polygon_edge.{quad_at_origin, quad_near_edge} and clipping.polygon.poly_fan.
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/clip_space_scene.h"

using namespace crevice;

namespace {

constexpr Size kSize = {50, 50};

// The half plane on the right of a line through p_px at this angle: a quad whose other edges are `far_px` away.
ClipSpaceScene half_plane(glm::dvec2 p_px, double angle, double far_px) {
    const glm::dvec2 along{std::cos(angle), std::sin(angle)}, across{-along.y, along.x};
    ClipSpaceScene scene{kSize, {}, {}};
    const auto at = [&](double a, double b) { return scene.at_screen(p_px + a * along + b * across); };
    scene.add_quad(at(-far_px, 0), at(far_px, 0), at(far_px, far_px), at(-far_px, far_px));
    return scene;
}

// How far a pixel's centre lies inside.
double distance_inside(glm::dvec2 p_px, double angle, int x, int y) {
    const glm::dvec2 to = glm::dvec2(x + 0.5, y + 0.5) - p_px;
    return to.y * std::cos(angle) - to.x * std::sin(angle);
}

}  // namespace

TEST_CASE(
    "polygon edge: a half plane covers its half, through the middle or near a side, its corners ever "
    "further") {
    for (const double far_px : {100.0, 3000.0, 30000.0, 1e6, 1e9}) {
        for (const glm::dvec2 p_px : {glm::dvec2(25, 25), {0.75, 25}, {49.25, 25}, {25, 0.75}, {25, 49.25}}) {
            for (int step = 0; step < 24; ++step) {
                // Not along the pixels: no centre lies on the line.
                const double angle = 0.05 + step * kPi / 12;
                const Image<std::int32_t> count = draw(half_plane(p_px, angle, far_px)).count;
                // A corner of float has so many pixels of rounding; its clip may add a step of 1/256.
                const double near_px = 0.01 + far_px * 0x1p-22;
                CAPTURE(far_px);
                CAPTURE(p_px.x);
                CAPTURE(p_px.y);
                CAPTURE(step);
                CHECK(pixels_against(kSize, [&](int x, int y) {
                          const double inside = distance_inside(p_px, angle, x, y);
                          const std::int32_t times = count.at(x, y);
                          return inside > near_px ? times == 1
                                                  : (inside < -near_px ? times == 0 : times <= 1);
                      }) == "");
            }
        }
    }
}

TEST_CASE(
    "polygon edge: poly_fan: a polygon of 360 far corners as a fan round one of them fills the picture "
    "once") {
    for (const double far_px : {200.0, 30000.0, 1e6}) {
        ClipSpaceScene scene{kSize, {}, {}};
        for (std::uint32_t i = 0; i < 360; ++i) {
            const double angle = i * kPi / 180;
            scene.add(scene.at_screen(25 + far_px * std::cos(angle), 25 + far_px * std::sin(angle)));
            if (i > 1) scene.triangles.push_back({0, i - 1, i});
        }
        CAPTURE(far_px);
        CHECK(differences(draw(scene).count, 1) == "");
    }
}
