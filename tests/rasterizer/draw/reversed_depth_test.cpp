// The rule of piglit's clip-control-depth-precision: with reversed z in floats two planes whose distances differ
// by ten units in the last place are told apart at every distance.
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/draw/normal_depth.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

constexpr Size kSize = {16, 16};

// Which of two facing squares the picture shows: they fill it, at these distances, in this order of drawing.
Image<std::int32_t> seen_square(float first, float second) {
    Scene scene = scene_of({facing_quad({0, 0, first}, first), facing_quad({0, 0, second}, second)});
    scene.camera.near_plane = 1;
    scene.camera.far_plane = 1e17;
    scene.camera.reversed_z = true;
    const ScreenGeometry geometry = screen_geometry(scene, scene.camera, kSize);
    const Image<std::int32_t> shown = visibility(geometry, DepthFormat::d32f, true, {}, {}).triangle;
    Image<std::int32_t> instance(kSize, -1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const std::int32_t number = shown.at(x, y);
            if (number != kNoTriangle)
                instance.at(x, y) = static_cast<std::int32_t>(geometry.triangle(number).triangle->instance);
        }
    }
    return instance;
}

}  // namespace

TEST_CASE(
    "reversed depth: the nearer of two planes ten last places apart is seen, from 10 to 1e16 units away") {
    for (float distance = 10; distance < 2e16f; distance *= 10) {
        const float nearer = distance * (1 - 10 * std::numeric_limits<float>::epsilon());
        CAPTURE(distance);
        CHECK(differences(seen_square(nearer, distance), 0) == "");
        CHECK(differences(seen_square(distance, nearer), 1) == "");
    }
}
