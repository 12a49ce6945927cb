// Walks: smooth closed paths through their stops; that of the atrium goes through no wall.
#include "scenes/camera_walk.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/draw/normal_depth.h"
#include "scenes/atrium.h"
#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

constexpr WalkStop kSquare[] = {
    {{0, 0, 0}, {5, 1, 0}}, {{2, 0, 0}, {5, 1, 5}}, {{2, 0, 2}, {0, 1, 5}}, {{0, 0, 2}, {0, 1, -5}}};

}  // namespace

TEST_CASE("walk: through every stop, closed, as smooth between stops as at them") {
    const Camera camera;
    for (int i = 0; i <= 4; ++i) {
        CAPTURE(i);
        const Camera at = walking_camera(camera, kSquare, 0.25 * i);
        CHECK(at.eye == kSquare[i % 4].eye);
        CHECK(at.target == kSquare[i % 4].target);
        CHECK(at.fov_y_rad == camera.fov_y_rad);
        // The slope at a stop is that between its neighbours, from both sides.
        constexpr double kStep = 1e-6;
        const glm::dvec3 before = at.eye - walking_camera(camera, kSquare, 0.25 * i - kStep).eye,
                         after = walking_camera(camera, kSquare, 0.25 * i + kStep).eye - at.eye;
        const glm::dvec3 expected = 0.5 * 4 * (kSquare[(i + 1) % 4].eye - kSquare[(i + 3) % 4].eye);
        CHECK(glm::length(before / kStep - expected) < 1e-3);
        CHECK(glm::length(after / kStep - expected) < 1e-3);
    }
    CHECK(walking_camera(camera, kSquare, 2.375).eye == walking_camera(camera, kSquare, 0.375).eye);
    CHECK(glm::length(walking_camera(camera, kSquare, -0.125).eye -
                      walking_camera(camera, kSquare, 0.875).eye) < 1e-12);
    // A spline through points of a straight line stays on it.
    const WalkStop line[] = {
        {{0, 0, 0}, {0, 0, 9}}, {{1, 0, 0}, {0, 0, 9}}, {{2, 0, 0}, {0, 0, 9}}, {{3, 0, 0}, {0, 0, 9}}};
    CHECK(glm::length(walking_camera(camera, line, 0.375).eye - glm::dvec3(1.5, 0, 0)) < 1e-12);
    CHECK_THROWS_AS(walking_camera(camera, std::span(kSquare, 2), 0), UsageError);
}

TEST_CASE("walk: that of the atrium begins at its camera and keeps clear of everything") {
    const Scene scene = atrium_scene();
    CHECK(kAtriumWalk[0].eye == scene.camera.eye);
    CHECK(kAtriumWalk[0].target == scene.camera.target);
    constexpr double kClear = 0.3;  // of everything that is seen
    constexpr int kFrames = 28;
    for (int frame = 0; frame < kFrames; ++frame) {
        const Camera camera = walking_camera(scene.camera, kAtriumWalk, static_cast<double>(frame) / kFrames);
        const Size size{32, 18};
        const GBuffer g = normal_depth(scene, camera, size);
        float nearest = 1e9f;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) nearest = std::min(nearest, g.view_depth.at(x, y));
        }
        CAPTURE(frame);
        CHECK(nearest > kClear);
        // Never outside: some ceiling, floor or wall is always near.
        CHECK(nearest < 12);
        CHECK(camera.eye.y > 1.5);
        CHECK(camera.eye.y < 2);
    }
}
