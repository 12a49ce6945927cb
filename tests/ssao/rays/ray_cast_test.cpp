#include "ssao/rays/ray_cast.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "tests/tools/every_run.h"
#include "tests/tools/ray_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// From everywhere, and every fourth from inside and parallel to an axis or a plane of two axes.
std::vector<Ray> rays_through(int count, std::uint32_t seed) {
    RandomNumbers random(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        glm::vec3 direction = random.direction();
        if (i % 4 == 0) direction[i / 4 % 3] = i % 8 == 0 ? 0.0f : -0.0f;
        if (i % 16 == 0) direction[(i / 4 + 1) % 3] = -0.0f;
        const glm::vec3 origin = random.in_cube(i % 2 == 0 ? 1.0f : 3.0f);
        rays.push_back({origin, random.between(0.1f, 10) * direction});
    }
    return rays;
}

// One triangle in the plane z = 4, its right angle at the origin's foot.
const Corners kTriangle = {glm::vec3(0, 0, 4), glm::vec3(2, 0, 4), glm::vec3(0, 2, 4)};

}  // namespace

TEST_CASE("every ray meets what testing every triangle finds") {
    const struct {
        const char* name;
        std::vector<Corners> triangles;
    } sets[] = {{"small", random_triangles(1500, 0.1f, 11)},
                {"large", random_triangles(60, 2, 12)},
                {"thin", thin_triangles(800, 13)},
                {"equal", std::vector<Corners>(40, random_triangles(1, 2, 14)[0])},
                {"shrinking", shrinking_triangles(56)}};
    for (const auto& set : sets) {
        const RayScene scene = scene_of_triangles(set.triangles);
        const std::vector<Ray> rays = rays_through(2000, 15);
        for (const float max_distance : {0.05f, 0.5f, kInfinity}) {
            std::vector<RayHit> expected;
            std::size_t hits = 0;
            for (const Ray& ray : rays) {
                expected.push_back(nearest_of_all(set.triangles, ray, max_distance));
                hits += expected.back().triangle >= 0;
            }
            CHECK((hits > 10 || max_distance < 0.1f));
            for (const Run& run : every_run()) {
                INFO(set.name << ", max_distance " << max_distance << ", " << run_text(run));
                const OccludedRays any = occluded(scene, rays, max_distance, run);
                const ClosestHits closest = closest_hits(scene, rays, max_distance, run);
                CHECK(any.refused == 0);
                CHECK(closest.refused == 0);
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    const bool right = same(closest.hits[i], expected[i]) &&
                                       (any.occluded[i] != 0) == (expected[i].triangle >= 0);
                    if (!right) FAIL_CHECK("ray " << i << ": " << text_of(rays[i]));
                }
            }
        }
    }
}

TEST_CASE("as many rays from one point as there are: each meets what testing every triangle finds") {
    const std::vector<Corners> triangles = random_triangles(400, 0.3f, 16);
    const RayScene scene = scene_of_triangles(triangles);
    RandomNumbers random(17);
    for (const int count : {1, 4, 5, 63, 64, 65, 200, 201}) {
        // Far from all triangles, or on one of them.
        const Corners& t = triangles[static_cast<std::size_t>(count)];
        const glm::vec3 middle = (t[0] + t[1] + t[2]) / 3.0f,
                        normal = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
        const glm::vec3 origin =
            count % 2 == 0 ? 2.0f * random.direction() : offset_origin(middle, normal, normal).origin;
        std::vector<Ray> rays;
        for (int i = 0; i < count; ++i) rays.push_back({origin, random.direction()});
        rays[0].direction.x = 0;
        if (count > 4) {
            rays[3].direction.y = -0.0f;
            rays[4].direction = glm::vec3(0);  // cannot be traced
        }
        for (const float max_distance : {0.7f, kInfinity}) {
            for (const Run& run : every_run()) {
                INFO(count << " rays, max_distance " << max_distance << ", " << run_text(run));
                const OccludedRays any = occluded(scene, rays, max_distance, run);
                CHECK(any.refused == (count > 4 ? 1 : 0));
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    const bool traced = count <= 4 || i != 4,
                               meets =
                                   traced && nearest_of_all(triangles, rays[i], max_distance).triangle >= 0;
                    if ((any.occluded[i] != 0) != meets) FAIL_CHECK("ray " << i << ": " << text_of(rays[i]));
                }
            }
        }
    }
}

TEST_CASE("one triangle: distance in lengths of the direction, weights of the corners, both sides") {
    const RayScene scene = scene_of_triangles({kTriangle});
    const RayHit front = closest_hit(scene, {{0.5f, 0.25f, 0}, {0, 0, 2}}, kInfinity);
    CHECK(front.triangle == 0);
    CHECK(front.distance == 2);
    CHECK(front.u == 0.25f);
    CHECK(front.v == 0.125f);
    const RayHit back = closest_hit(scene, {{0.5f, 0.25f, 8}, {0, 0, -1}}, kInfinity);
    CHECK(back.triangle == 0);
    CHECK(back.distance == 4);
    CHECK(back.u == 0.25f);
    CHECK(back.v == 0.125f);
    CHECK(closest_hit(scene, {{1.5f, 1.5f, 0}, {0, 0, 1}}, kInfinity).triangle == -1);
    CHECK(closest_hit(scene, {{0.5f, 0.25f, 0}, {0, 0, -1}}, kInfinity).triangle == -1);
}

TEST_CASE("hits count at distances in (0, max]") {
    const RayScene scene = scene_of_triangles({kTriangle});
    const Ray ray = {{0.5f, 0.25f, 0}, {0, 0, 1}};
    CHECK(occluded(scene, ray, 4));
    CHECK_FALSE(occluded(scene, ray, std::nextafter(4.0f, 0.0f)));
    CHECK(occluded(scene, ray, kInfinity));
    for (const float z : {-1.0f, 1.0f}) {
        CAPTURE(z);
        CHECK_FALSE(occluded(scene, {{0.5f, 0.25f, 4}, {0, 0, z}}, kInfinity));
        const float before = std::nextafter(4.0f, z > 0 ? 0.0f : 8.0f);
        CHECK(occluded(scene, {{0.5f, 0.25f, before}, {0, 0, z}}, kInfinity));
    }
}

TEST_CASE("of equally near triangles the lowest index is met") {
    std::vector<Corners> triangles = random_triangles(500, 0.1f, 21);
    for (Corners& t : triangles) {
        for (glm::vec3& p : t) p.z += 6;
    }
    for (int i = 0; i < 30; ++i) triangles.insert(triangles.begin() + 17 * i, kTriangle);
    const RayHit hit = closest_hit(scene_of_triangles(triangles), {{0.5f, 0.25f, 0}, {0, 0, 1}}, kInfinity);
    CHECK(hit.triangle == 0);
    CHECK(hit.distance == 4);
}

TEST_CASE("a ray in the plane of a triangle, or along its edge, meets nothing and gives numbers") {
    const RayScene scene = scene_of_triangles({kTriangle});
    RandomNumbers random(31);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 d = random.direction();
        const Ray ray = {{random.between(-3, 3), random.between(-3, 3), 4},
                         {d.x, d.y, i % 2 == 0 ? 0.0f : -0.0f}};
        CAPTURE(text_of(ray));
        const RayHit hit = closest_hit(scene, ray, kInfinity);
        CHECK(hit.triangle == -1);
        CHECK_FALSE(std::isnan(hit.distance));
    }
    CHECK_FALSE(occluded(scene, {{-1, 0, 4}, {1, 0, 0}}, kInfinity));
    CHECK_FALSE(occluded(scene, {{3, -1, 4}, {-1, 1, 0}}, kInfinity));
}

TEST_CASE("rays that cannot be traced are named, and counted in batches") {
    const RayScene scene = scene_of_triangles({kTriangle});
    const glm::vec3 o(0.5f, 0.25f, 0), d(0, 0, 1);
    const Ray bad[] = {{o, {0, 0, 0}},          {o, {-0.0f, 0, 0}},    {o, {kNan, 0, 1}},
                       {o, {0, kInfinity, 1}},  {o, {0, 0, 0x1p-37f}}, {{kNan, 0, 0}, d},
                       {{0, -kInfinity, 0}, d}, {{0, 0, 0x1p37f}, d}};
    for (const Ray& ray : bad) {
        CAPTURE(text_of(ray));
        CHECK_THROWS_AS(occluded(scene, ray, 1), UsageError);
        CHECK_THROWS_AS(closest_hit(scene, ray, 1), UsageError);
    }
    std::vector<Ray> rays(std::begin(bad), std::end(bad));
    rays.push_back({o, d});
    for (const Run& run : every_run()) {
        INFO(run_text(run));
        const OccludedRays any = occluded(scene, rays, kInfinity, run);
        CHECK(any.refused == std::size(bad));
        CHECK(any.occluded == std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 0, 1});
        const ClosestHits closest = closest_hits(scene, rays, kInfinity, run);
        CHECK(closest.refused == std::size(bad));
        CHECK(closest.hits.front().triangle == -1);
        CHECK(closest.hits.back().distance == 4);
    }
    for (const float max_distance : {0.0f, -1.0f, kNan}) {
        CAPTURE(max_distance);
        CHECK_THROWS_AS(occluded(scene, Ray{o, d}, max_distance), UsageError);
        CHECK_THROWS_AS(closest_hits(scene, rays, max_distance), UsageError);
    }
}

TEST_CASE("an empty scene is never hit") {
    const RayScene scene = ray_scene(scene_of({}), glm::dvec3(0));
    const std::vector<Ray> rays = rays_through(100, 41);
    for (const std::uint8_t hit : occluded(scene, rays, kInfinity).occluded) CHECK(hit == 0);
    for (const RayHit& hit : closest_hits(scene, rays, kInfinity).hits) CHECK(hit.triangle == -1);
}
