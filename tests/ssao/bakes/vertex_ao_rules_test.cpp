// What a vertex is given, besides the closed forms of vertex_ao_test.cpp: by which triangles, at which cost,
// with which error.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "tests/tools/every_run.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"
#include "tests/tools/vertex_ao_checks.h"

using namespace crevice;

TEST_CASE("vertex ao: a vertex inside another body is closed, one without a triangle open") {
    Mesh floor = grid_mesh(8, 8, 3, 3);
    floor.positions.push_back({1, 2, 3});
    floor.positions.push_back({kNan, 2, 3});
    floor.normals.resize(11, {0, 1, 0});
    floor.triangles.insert(floor.triangles.end(), {{0, 0, 1}, {0, 1, 10}});
    floor.parts = {{0, 10, 0}};
    const Scene scene = scene_of({floor, box_mesh(glm::dvec3(1), 1)});
    const VertexAo ao = from_corners(scene);
    CHECK(ao.accessibility[0][4] == 0);  // in the middle, inside the box
    for (const std::size_t alone : {9u, 10u}) CHECK(ao.accessibility[0][alone] == 1);
    CHECK(ao.unused == 2);
    const VertexAo tutorial = from_centroids(scene);
    CHECK(tutorial.accessibility[0][9] == 1);
    CHECK(tutorial.unused == 2);
    for (const float value : tutorial.accessibility[0]) CHECK(value >= 0);
}

TEST_CASE("vertex ao: centroids: a vertex is the mean of its triangles, each counting the same") {
    // A triangle in the open and one that lies on the floor of a closed room, with two vertices in common.
    Mesh mesh = quad_mesh({glm::vec3(-1, 0, 0), {-1, 0, 1}, {0, 0, 1}, {9, 0, -1}}, {0, 1, 0});
    const Scene scene =
        scene_of({mesh, quad_mesh({glm::vec3(-5, 4, -5), {-5, 4, 5}, {5, 4, 5}, {5, 4, -5}}, {0, 1, 0})});
    const VertexAo ao = from_centroids(scene);
    const std::vector<SurfacePoint> points = triangle_centroids(rays_of(scene));
    REQUIRE(points.size() == 4);
    CHECK(points[0].position == glm::vec3(-2.0f / 3, 0, 2.0f / 3));
    CHECK(points[0].geometric_normal == glm::vec3(0, 1, 0));
    const float first = ao.accessibility[0][1], second = ao.accessibility[0][3];
    CHECK(first != second);
    CHECK(ao.accessibility[0][0] == doctest::Approx(0.5 * (first + second)));
    CHECK(ao.accessibility[0][2] == ao.accessibility[0][0]);
    CHECK(ao.rays_cast == 4 * 32);
}

TEST_CASE("vertex ao: corners: triangles count by their area") {
    // Around one vertex, a large triangle in the open and a small one under a lid.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {-30, 0, 0}, {0, 0, 30}, {0.5f, 0, -0.25f}, {0.25f, 0, -0.5f}};
    mesh.normals.assign(5, {0, 1, 0});
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
    mesh.parts = {{0, 2, 0}};
    Mesh lid = grid_mesh(0.5, 0.5, 2, 2);
    for (glm::vec3& p : lid.positions) p += glm::vec3(0.25f, 0.001f, -0.25f);
    const Scene scene = scene_of({mesh, lid});
    CHECK(from_corners(scene).accessibility[0][0] > 0.99f);
    CHECK(from_corners(scene).accessibility[0][3] < 0.8f);
}

TEST_CASE("vertex ao: vertices of one place and one normal have one value, across instances too") {
    const Mesh tube = cylinder_mesh(0.5, 0.5, 2, 12, 3);
    Scene scene = scene_of({tube, grid_mesh(4, 4, 3, 3)});
    scene.instances = {placed(0, {0, 1, 0}), placed(1, {-2, 0, 0}), placed(1, {2, 0, 0})};
    const VertexAo ao = from_corners(scene);
    int pairs = 0;
    for (std::size_t a = 0; a < tube.positions.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (tube.positions[a] != tube.positions[b] || tube.normals[a] != tube.normals[b]) continue;
            ++pairs;
            CHECK(ao.accessibility[0][a] == ao.accessibility[0][b]);
        }
    }
    CHECK(pairs >= 4);
    for (std::size_t row = 0; row < 3; ++row) {
        CAPTURE(row);  // the left grid's right border is the right grid's left one
        CHECK(ao.accessibility[1][3 * row + 2] == ao.accessibility[2][3 * row]);
    }
    CHECK(ao.accessibility[1][5] < 1);  // at the tube's foot
}

TEST_CASE("vertex ao: of mirrored instances the front is what counts") {
    Mesh floor = grid_mesh(4, 4, 3, 3), below = grid_mesh(40, 40, 2, 2);
    Scene scene = scene_of({floor, below});
    scene.instances = {placed(0, {0, 0, 0}, {-1, 1, 1}), placed(1, {0, -0.01f, 0})};
    check_all(from_corners(scene), 1);
    const VertexAo tutorial = from_centroids(scene);
    for (const float value : tutorial.accessibility[0]) CHECK(value == 1);
}

TEST_CASE("vertex ao: corners: the side that the vertex normals point to is what counts") {
    Mesh floor = grid_mesh(4, 4, 3, 3);
    for (glm::vec3& n : floor.normals) n = -n;
    check_all(from_corners(scene_of({floor})), 1);
    Mesh lid = grid_mesh(40, 40, 2, 2);
    for (glm::vec3& p : lid.positions) p.y = -0.01f;
    const VertexAo turned = from_corners(scene_of({floor, lid}));
    for (const float value : turned.accessibility[0]) CHECK(value < 0.1f);
    for (glm::vec3& n : floor.normals) n = glm::vec3(0);  // none: the triangles' own
    const VertexAo without = from_corners(scene_of({floor, lid}));
    for (const float value : without.accessibility[0]) CHECK(value == 1);
}

TEST_CASE("vertex ao: a vertex's rays are shared out to its triangles; another seed casts others") {
    const Scene plane = scene_of({grid_mesh(8, 8, 5, 4)});  // 20 vertices, 24 triangles
    RayAoSettings settings = kRays;
    settings.rays = 100;
    const VertexAo ao = from_corners(plane, settings);
    CHECK(ao.rays_cast >= 20 * 100);
    CHECK(ao.rays_cast < 20 * 100 + 3 * 24);
    const Scene scene = still_life();
    const std::vector<float> before = joined(from_corners(scene, settings));
    settings.seed = 2;
    CHECK(joined(from_corners(scene, settings)) != before);
    RayAoSettings other = kTutorialRays;
    other.seed = 2;
    CHECK(joined(from_centroids(scene, other)) != joined(from_centroids(scene)));
}

TEST_CASE("vertex ao: the error of independent rays falls as their number to the power -1/2") {
    const Scene scene = still_life();
    const RayScene rays = rays_of(scene);
    RayAoSettings many = kTutorialRays;
    many.rays = 8192;
    many.sequence = RaySequence::sobol;
    const std::vector<float> truth = joined(vertex_ao_from_centroids(scene, rays, many));
    std::vector<double> log_rays, log_error;
    for (const int count : {2, 8, 32, 128}) {
        double squares = 0;
        RayAoSettings settings = kTutorialRays;
        settings.rays = count;
        for (std::uint32_t seed = 0; seed < 4; ++seed) {
            settings.seed = seed;
            const std::vector<float> values = joined(vertex_ao_from_centroids(scene, rays, settings));
            for (std::size_t i = 0; i < truth.size(); ++i) {
                const double off = static_cast<double>(values[i]) - static_cast<double>(truth[i]);
                squares += off * off;
            }
        }
        log_rays.push_back(std::log2(count));
        log_error.push_back(0.5 * std::log2(squares));
    }
    const double slope = (log_error.back() - log_error.front()) / (log_rays.back() - log_rays.front());
    CHECK(slope == doctest::Approx(-0.5).epsilon(0.04));
}

TEST_CASE(
    "vertex ao: the same bits at every thread count, lane count and instruction set; progress adds up") {
    const Scene scene = still_life();
    const RayScene rays = rays_of(scene);
    RayAoSettings settings = kRays;
    settings.rays = 50;
    settings.radius = 2;
    const std::vector<float> corners = joined(vertex_ao_from_corners(scene, rays, settings));
    const std::vector<float> centroids = joined(vertex_ao_from_centroids(scene, rays, settings));
    for_every_run({.threads = {1, 2, 7}}, [&](const Run& run) {
        long long done = 0, also_done = 0;
        CHECK(joined(vertex_ao_from_corners(scene, rays, settings, run, [&](long long n) { done += n; })) ==
              corners);
        CHECK(joined(vertex_ao_from_centroids(scene, rays, settings, run,
                                              [&](long long n) { also_done += n; })) == centroids);
        CHECK(done == static_cast<long long>(rays.triangles.size()));
        CHECK(also_done == done);
    });
}

TEST_CASE("vertex ao: a scene in other units has the same bits") {
    const Scene scene = still_life();
    for (const int k : {-12, 9}) {
        CAPTURE(k);
        RayAoSettings other = kRays;
        other.rays = 32;
        CHECK(joined(from_corners(scaled(scene, k), other)) == joined(from_corners(scene, other)));
        CHECK(joined(from_centroids(scaled(scene, k))) == joined(from_centroids(scene)));
    }
}

TEST_CASE(
    "vertex ao: settings out of range are named; a lift that matters is counted; no triangles, no rays") {
    const Scene scene = scene_of({grid_mesh(8, 8, 5, 4)});
    const RayScene rays = rays_of(scene);
    for (const float radius : {0.0f, -1.0f, kNan}) {
        CAPTURE(radius);
        RayAoSettings settings = kRays;
        settings.radius = radius;
        CHECK_THROWS_AS(vertex_ao_from_corners(scene, rays, settings), UsageError);
        CHECK_THROWS_AS(vertex_ao_from_centroids(scene, rays, settings), UsageError);
    }
    RayAoSettings settings = kRays;
    settings.rays = 0;
    CHECK_THROWS_AS(vertex_ao_from_corners(scene, rays, settings), UsageError);
    settings.rays = 8;
    CHECK(from_corners(scene, settings).lifted_far == 0);
    settings.radius = 1e-5f;
    CHECK(from_corners(scene, settings).lifted_far == 3 * rays.triangles.size());
    CHECK(from_centroids(scene, settings).lifted_far == rays.triangles.size());
    const VertexAo none = from_corners(scene_of({}));
    CHECK(none.rays_cast == 0);
    CHECK(none.accessibility.empty());
}
