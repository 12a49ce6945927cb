#include "chapters/props/limit_scenes.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "tests/tools/image_checks.h"

using namespace crevice;

TEST_CASE("the darkest column counts the middle rows alone") {
    Image<float> ao({6, 20}, 1.0f);
    CHECK(darkest_column(ao) == 1);
    for (int y = 0; y < 20; ++y) ao.at(4, y) = y >= 8 && y < 12 ? 0.5f : 0.0f;
    CHECK(darkest_column(ao) == 0.5);
    ao.at(1, 9) = 0;
    CHECK(darkest_column(ao) == 0.5);
    ao.at(1, 8) = ao.at(1, 10) = 0;
    CHECK(darkest_column(ao) == 0.25);
}

TEST_CASE("a plate farther from a wall than the rays are long does not shade it") {
    const Size size{96, 54};
    for (const float distance : {0.3f, 1.4f}) {
        CAPTURE(distance);
        const Scene scene = plate_scene(distance);
        const GBuffer gbuffer = normal_depth(scene, scene.camera, size);
        const double darkest = darkest_column(ray_picture(scene, scene.camera, gbuffer, {.rays = 32}));
        CHECK((distance > 0.5f ? darkest == 1 : darkest < 0.9));
    }
}

TEST_CASE("cameras round the shelf stand on a circle and look at one point") {
    const Scene scene = shelf_scene();
    for (int i = 0; i < kDirections; ++i) {
        CAPTURE(i);
        const Camera camera = seen_from(scene, i), next = seen_from(scene, i + 1);
        CHECK(std::hypot(camera.eye.x, camera.eye.z) == doctest::Approx(1.5));
        CHECK(camera.eye.y == 4);
        CHECK(glm::distance(camera.eye, next.eye) == doctest::Approx(3 * std::sin(3.14159265 / kDirections)));
        CHECK(camera.target == scene.camera.target);
    }
}

TEST_CASE("the larger picture's middle is the smaller picture") {
    const DownwardViews views = downward_views();
    const Scene scene = shelf_scene();
    const Size size{32, 18};
    Camera camera = views.without_sphere, larger = views.larger;
    camera.eye = larger.eye = {1, 2, -2};
    camera.target = larger.target = {0, 0, 0};
    const GBuffer middle = normal_depth(scene, camera, size), whole = normal_depth(scene, larger, {64, 36});
    CHECK(pixels_against(size, [&](int x, int y) {
              const float a = middle.view_depth.at(x, y), b = whole.view_depth.at(x + 16, y + 9);
              return a == b || std::fabs(a - b) < 1e-3f * a;
          }) == "");
}

TEST_CASE("rays through a scene meet what its depth buffer hides; on a bare floor both are open") {
    const Scene floor = bare_floor();
    const Size size{64, 36};
    const GBuffer gbuffer = normal_depth(floor, floor.camera, size);
    const RayAoSettings settings{.rays = 16};
    CHECK(other_than(ray_picture(floor, floor.camera, gbuffer, settings), 1) == "");
    CHECK(values_against(depth_buffer_picture(floor, floor.camera, gbuffer, settings),
                         [](float a) { return a > 0.99f; }) == "");
    const Scene shelf = shelf_scene();
    const Camera camera = seen_from(shelf, 0);
    const GBuffer seen = normal_depth(shelf, camera, size);
    const Image<float> lost = difference(depth_buffer_picture(shelf, camera, seen, settings),
                                         ray_picture(shelf, camera, seen, settings));
    CHECK(other_than(lost, 0) != "");
}
