// Slivers round one vertex, so narrow that snapping their corners turns half of them over on the screen: each
// pixel still shows the side that geometry says, and nothing stands in the way of a flat fan.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "ssao/rays/ray_cast_ao.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

constexpr Size kSize{80, 60};
constexpr int kSlivers = 20000;

// A disc in a plane askew to the axes, in front of an eye at the origin.
Scene fan_scene(bool reversed) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.5, 0.7, -1)), centre = {0.1, -0.2, 4};
    const glm::dvec3 right = glm::normalize(glm::cross(normal, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, normal);
    Mesh mesh;
    mesh.positions = {glm::vec3(centre)};
    for (std::uint32_t i = 0; i < kSlivers; ++i) {
        const double angle = 2 * kPi * i / kSlivers;
        mesh.positions.emplace_back(centre + 1.5 * (std::cos(angle) * right + std::sin(angle) * up));
        const std::uint32_t here = 1 + i, next = 1 + (i + 1) % kSlivers;
        mesh.triangles.push_back({0, reversed ? here : next, reversed ? next : here});
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(reversed ? -normal : normal));
    mesh.parts = {{0, kSlivers, 0}};
    Scene scene = scene_of({mesh});
    scene.two_sided = true;
    return scene;
}

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
