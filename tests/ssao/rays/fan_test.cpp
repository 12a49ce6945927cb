// Slivers round one vertex, so narrow that snapping their corners turns half of them over on the screen: each
// pixel still shows the side that geometry says, and nothing stands in the way of a flat fan.
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "ssao/rays/ray_cast_ao.h"
#include "tests/tools/fan_scene.h"

using namespace crevice;

namespace {

constexpr Size kSize{80, 60};

}  // namespace

TEST_CASE("fan: every pixel of a disc of slivers has the disc's normal, and its rays leave it") {
    for (const bool reversed : {false, true}) {
        CAPTURE(reversed);
        const Scene scene = fan_scene(reversed);
        const SurfacePoints seen =
            surface_points(scene, scene.camera, normal_depth(scene, scene.camera, kSize));
        REQUIRE(seen.points.size() > 500);
        const std::vector<float> open =
            ray_cast_ao(ray_scene(scene, scene.camera.eye), seen.points, {.rays = 32, .radius = 1});
        for (std::size_t i = 0; i < seen.points.size(); ++i) {
            const SurfacePoint& p = seen.points[i];
            CAPTURE(seen.pixel[i] % kSize.width);
            CAPTURE(seen.pixel[i] / kSize.width);
            CHECK(glm::dot(p.normal, glm::normalize(glm::vec3(0.5f, 0.7f, -1))) > 0.9999f);
            CHECK(glm::dot(p.normal, p.geometric_normal) > 0);
            CHECK(open[i] == 1);
        }
    }
}
