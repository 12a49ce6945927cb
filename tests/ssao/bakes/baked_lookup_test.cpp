#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "ssao/bakes/baked_lookup.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

struct Seen {
    Scene scene = still_life();
    RayScene rays = ray_scene(scene, scene.camera.eye);
    SurfacePoints points = surface_points(scene, scene.camera, normal_depth(scene, scene.camera, {96, 64}));
    std::vector<RayHit> hits = triangles_below(rays, points.points);
};

}  // namespace

TEST_CASE("triangles below: each pixel's own, from far and near, in other units") {
    for (const int k : {-30, 0, 30}) {
        Seen seen;
        seen.scene = scaled(still_life(), k);
        const Camera& camera = seen.scene.camera;
        seen.rays = ray_scene(seen.scene, camera.eye);
        seen.points = surface_points(seen.scene, camera, normal_depth(seen.scene, camera, {96, 64}));
        seen.hits = triangles_below(seen.rays, seen.points.points);
        CAPTURE(k);
        REQUIRE(seen.hits.size() == seen.points.points.size());
        int elsewhere = 0;
        for (std::size_t i = 0; i < seen.hits.size(); ++i) {
            const RayHit& hit = seen.hits[i];
            REQUIRE(hit.triangle >= 0);
            const Corners& c = seen.rays.triangles[static_cast<std::size_t>(hit.triangle)];
            const glm::vec3 at = (1 - hit.u - hit.v) * c[0] + hit.u * c[1] + hit.v * c[2];
            elsewhere += glm::length(at - seen.points.points[i].position) > std::ldexp(1e-4f, k) ? 1 : 0;
        }
        CHECK(elsewhere == 0);
    }
}

TEST_CASE("looked up: what is linear over the surface comes back, from vertices and from a map") {
    const Seen seen;
    VertexAo heights;
    for (const Instance& instance : seen.scene.instances) {
        heights.accessibility.emplace_back();
        for (const glm::vec3& p : seen.scene.meshes[static_cast<std::size_t>(instance.mesh)].positions)
            heights.accessibility.back().push_back(p.y + 2 * p.z);
    }
    const std::vector<float> values = looked_up(seen.scene, seen.rays, heights, seen.hits);
    const LightmapCharts charts = lightmap_charts(seen.scene, seen.rays, {.texels = 64});
    Image<float> ramp({64, 64}, 0);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) ramp.at(x, y) = (float(x) + 3 * float(y) + 2) / 64;
    }
    const std::vector<float> ramp_values = looked_up(charts, ramp, seen.hits);
    REQUIRE(values.size() == seen.hits.size());
    REQUIRE(ramp_values.size() == seen.hits.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const glm::vec3 p = seen.points.points[i].position;
        const RayHit& hit = seen.hits[i];
        const auto& [a, b, c] = charts.texcoords[static_cast<std::size_t>(hit.triangle)];
        const glm::vec2 at = (1 - hit.u - hit.v) * a + hit.u * b + hit.v * c;
        CAPTURE(i);
        CHECK(values[i] == doctest::Approx(p.y + 2 * p.z).epsilon(1e-3));
        CHECK(ramp_values[i] == doctest::Approx(at.x + 3 * at.y).epsilon(1e-3));
    }
}

TEST_CASE("looked up: a point on no triangle is open") {
    const Seen seen;
    const SurfacePoint above{{0, 50, 4}, {0, 1, 0}, {0, 1, 0}};
    const std::vector<RayHit> none = triangles_below(seen.rays, {&above, 1});
    REQUIRE(none.size() == 1);
    CHECK(none[0].triangle == -1);
    CHECK(looked_up(LightmapCharts{}, Image<float>({1, 1}, 0.5f), none) == std::vector<float>{1});
    CHECK(looked_up(seen.scene, seen.rays, VertexAo{}, none) == std::vector<float>{1});
}
