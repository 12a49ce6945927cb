// No ray leaves a closed mesh between its triangles, and none meets the surface it starts on.
#include <array>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "scenes/cube_sphere.h"
#include "scenes/shapes.h"
#include "tests/tools/noise.h"
#include "tests/tools/ray_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// A closed sphere with bumps, about 1 around the origin; all of it is seen from there.
Mesh bumpy_sphere() {
    const CubeSphere sphere = cube_sphere(16);
    Mesh mesh;
    for (std::size_t i = 0; i < sphere.directions.size(); ++i) {
        const double radius = 1 + 0.2 * noise(5, static_cast<int>(i), 0);
        mesh.positions.emplace_back(radius * sphere.directions[i]);
    }
    mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
    mesh.triangles = sphere.triangles;
    mesh.parts = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), 0}};
    return mesh;
}

// From `origin` to every corner, to points of every edge and face, and along the axes with zeros of both
// signs.
std::vector<Ray> rays_at_seams(const RayScene& scene, glm::vec3 origin) {
    std::vector<Ray> rays;
    for (const Corners& t : scene.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3 a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
            for (const glm::vec3 target :
                 {a, 0.5f * (a + b), 0.75f * a + 0.25f * b, 0.9f * a + 0.1f * b, 0.5f * a + 0.25f * (b + c)})
                rays.push_back({origin, target - origin});
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {-1.0f, 1.0f}) {
            for (const float zero : {0.0f, -0.0f}) {
                glm::vec3 d(zero);
                d[axis] = sign;
                rays.push_back({origin, d});
                d[(axis + 1) % 3] = -zero;
                rays.push_back({origin, d});
            }
        }
    }
    return rays;
}

float largest_coordinate(glm::vec3 p) {
    return std::max(std::abs(p.x), std::max(std::abs(p.y), std::abs(p.z)));
}

// A convex shape of about the size of `distance`, that far in front of the origin.
struct ConvexShape {
    const char* name;
    Mesh mesh;
};
std::vector<ConvexShape> convex_shapes(float distance) {
    const auto placed = [&](Mesh mesh) {
        for (glm::vec3& p : mesh.positions) p = distance * (p + glm::vec3(0.3f, -0.7f, 1));
        return mesh;
    };
    return {{"plane", placed(grid_mesh(8, 8, 3, 4))},
            {"cube", placed(box_mesh({0.8, 0.8, 0.8}, 2))},
            {"sphere", placed(sphere_mesh(0.5, 24, 16))}};
}

}  // namespace

TEST_CASE("no ray leaves a closed mesh, at any scale") {
    for (int k = -20; k <= 20; k += 4) {
        CAPTURE(k);
        Mesh mesh = bumpy_sphere();
        for (glm::vec3& p : mesh.positions) p *= std::ldexp(1.0f, k);
        const RayScene scene = ray_scene(scene_of({mesh}), glm::dvec3(0));
        REQUIRE(scene.triangles.size() == 12 * 16 * 16);
        for (const glm::vec3 inside :
             {glm::vec3(0), glm::vec3(0.3f, -0.2f, 0.1f), glm::vec3(0.0625f, 0, -0.5f)}) {
            const std::vector<Ray> rays = rays_at_seams(scene, std::ldexp(1.0f, k) * inside);
            const OccludedRays any = occluded(scene, rays, kInfinity);
            const ClosestHits closest = closest_hits(scene, rays, kInfinity);
            CHECK(any.refused == 0);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const bool met = any.occluded[i] != 0 && closest.hits[i].triangle >= 0;
                if (!met) FAIL_CHECK("ray " << i << " passes between: " << text_of(rays[i]));
            }
        }
    }
}

TEST_CASE("a scene in other units has the same hits") {
    const Mesh mesh = bumpy_sphere();
    const RayScene scene = ray_scene(scene_of({mesh}), glm::dvec3(0));
    std::vector<Ray> rays = rays_at_seams(scene, {0.3f, -0.2f, 0.1f});
    const ClosestHits expected = closest_hits(scene, rays, 0.9f);
    for (const int k : {-20, -3, 7, 20}) {
        CAPTURE(k);
        const float factor = std::ldexp(1.0f, k);
        Mesh other = mesh;
        for (glm::vec3& p : other.positions) p *= factor;
        const RayScene scaled_scene = ray_scene(scene_of({other}), glm::dvec3(0));
        std::vector<Ray> scaled_rays = rays;
        for (Ray& ray : scaled_rays) ray = {factor * ray.origin, factor * ray.direction};
        const ClosestHits hits = closest_hits(scaled_scene, scaled_rays, 0.9f);
        std::size_t unlike = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) unlike += !same(hits.hits[i], expected.hits[i]);
        CHECK(unlike == 0);
    }
}

TEST_CASE("rays that leave a convex surface never meet it") {
    RandomNumbers random(51);
    for (const float distance : {1.0f, 10.0f, 100.0f, 1e3f, 1e4f, 1e5f, 1e6f, 1e7f}) {
        for (const ConvexShape& shape : convex_shapes(distance)) {
            INFO(shape.name << " at " << distance);
            const RayScene scene = ray_scene(scene_of({shape.mesh}), glm::dvec3(0));
            std::vector<Ray> seen, leaving;
            for (int i = 0; i < 125000; ++i)
                seen.push_back({glm::vec3(0), glm::vec3(0.3f, -0.7f, 1) + random.in_cube(0.6f)});
            const ClosestHits hits = closest_hits(scene, seen, kInfinity);
            for (std::size_t i = 0; i < seen.size(); ++i) {
                if (hits.hits[i].triangle < 0) continue;
                const glm::vec3 p = hits.hits[i].distance * seen[i].direction,
                                n = geometric_normal(scene, hits.hits[i].triangle);
                glm::vec3 d = random.direction();
                if (glm::dot(d, n) < 0) d = -d;
                if (glm::dot(d, n) < 1e-4f) continue;
                const LiftedOrigin lifted = offset_origin(p, n, d);
                CHECK(lifted.offset <= 5e-7f * largest_coordinate(p));
                leaving.push_back({lifted.origin, d});
            }
            CHECK(leaving.size() > 30000);
            const OccludedRays any = occluded(scene, leaving, kInfinity);
            for (std::size_t i = 0; i < leaving.size(); ++i) {
                if (any.occluded[i] != 0) FAIL_CHECK("ray " << i << ": " << text_of(leaving[i]));
            }
        }
    }
}

TEST_CASE("an origin is lifted to the side its ray goes to, in proportion to its largest coordinate") {
    const glm::vec3 p(3, -5, 2), n(0, 1, 0);
    CHECK(offset_origin(p, n, {0.5f, 0.5f, 0}).origin.y > p.y);
    CHECK(offset_origin(p, n, {0.5f, -0.5f, 0}).origin.y < p.y);
    CHECK(offset_origin(p, n, n).offset == 5 * kOriginOffset);
    CHECK(offset_origin(1024.0f * p, n, n).origin == 1024.0f * offset_origin(p, n, n).origin);
}
