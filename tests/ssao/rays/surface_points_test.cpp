#include "ssao/rays/surface_points.h"

#include <cmath>
#include <cstring>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "ssao/rays/ray_cast.h"
#include "tests/tools/every_run.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize{64, 36};

struct View {
    std::string name;
    Camera camera;
    DepthFormat format = DepthFormat::d32f;
};

std::vector<View> views() {
    const Camera plain = still_life().camera;
    View reversed{"reversed z", plain}, orthographic{"orthographic", plain},
        coarse{"d16", plain, DepthFormat::d16}, turned{"turned", plain};
    reversed.camera.reversed_z = true;
    orthographic.camera.projection = Projection::orthographic;
    orthographic.camera.ortho_height = 6;
    turned.camera.eye = {2, 1.5, -1};
    turned.camera.target = {-0.5, -0.5, 4};
    return {{"plain", plain}, reversed, orthographic, coarse, turned};
}

GBuffer gbuffer_of(const Scene& scene, const View& view, const Run& run = {}) {
    NormalDepthSettings settings;
    settings.depth_format = view.format;
    return normal_depth(scene, view.camera, kSize, settings, run);
}

bool same(const SurfacePoints& a, const SurfacePoints& b) {
    return a.pixel == b.pixel && a.points.size() == b.points.size() &&
           std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(SurfacePoint)) == 0;
}

}  // namespace

TEST_CASE("surface points: the pixels that show a surface, each in its triangle's plane and facing the eye") {
    const Scene scene = still_life();
    for (const View& view : views()) {
        CAPTURE(view.name);
        const GBuffer g = gbuffer_of(scene, view);
        const SurfacePoints points = surface_points(scene, view.camera, g);
        const RayScene rays = ray_scene(scene, view.camera.eye);
        const CameraMatrices matrices = camera_matrices(view.camera, kSize);
        std::size_t next = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                if (g.view_depth.at(x, y) == kInfinity) continue;
                CAPTURE(x);
                CAPTURE(y);
                REQUIRE(next < points.pixel.size());
                CHECK(points.pixel[next] == y * kSize.width + x);
                const SurfacePoint& p = points.points[next++];
                const glm::vec3 p_view = glm::mat3(matrices.view_from_relative) * p.position;
                CHECK(p_view.z == doctest::Approx(g.view_depth.at(x, y)).epsilon(1e-5));
                const glm::vec3 n_view = glm::mat3(matrices.view_from_relative) * p.normal;
                CHECK(glm::length(n_view - g.normal.at(x, y)) < 1e-5f);
                CHECK(std::abs(glm::length(p.geometric_normal) - 1) < 1e-6f);
                const glm::vec3 sight = view.camera.projection == Projection::perspective
                                            ? p.position
                                            : glm::mat3(matrices.relative_from_view) * glm::vec3(0, 0, 1);
                CHECK(glm::dot(p.geometric_normal, sight) < 0);
                // A triangle lies under the point, at no distance that a float can tell.
                const float up = 0.01f;
                const RayHit under =
                    closest_hit(rays, {p.position + up * p.geometric_normal, -p.geometric_normal}, 0.02f);
                CHECK(std::abs(under.distance - up) < 4e-6f);
            }
        }
        CHECK(next == points.pixel.size());
        CHECK(points.points.size() == points.pixel.size());
    }
}

// Coverage is decided with snapped corners, so a pixel may show a triangle just beyond its end.
TEST_CASE("surface points lie within a triangle, also where a pixel shows one beyond its end") {
    Scene scene = still_life();
    scene.two_sided = true;
    scene.camera.near_plane = 1.5;  // cuts through the nearer things: clipped triangles, seen from behind
    const RayScene rays = ray_scene(scene, scene.camera.eye);
    const Size size{480, 270};
    const SurfacePoints points = surface_points(scene, scene.camera, normal_depth(scene, scene.camera, size));
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const SurfacePoint& p = points.points[i];
        CAPTURE(points.pixel[i] % size.width);
        CAPTURE(points.pixel[i] / size.width);
        CHECK(glm::dot(p.geometric_normal, p.position) < 1e-3f * glm::length(p.position));
        // A shade to each side, so that rounding at an edge does not count.
        bool found = false;
        for (const glm::vec3 aside : {glm::vec3(0),
                                      {1e-5f, 0, 0},
                                      {-1e-5f, 0, 0},
                                      {0, 1e-5f, 0},
                                      {0, -1e-5f, 0},
                                      {0, 0, 1e-5f},
                                      {0, 0, -1e-5f}}) {
            const glm::vec3 above = p.position + aside + 1e-3f * p.geometric_normal;
            found = found || closest_hit(rays, {above, -p.geometric_normal}, 2e-3f).distance < kInfinity;
        }
        CHECK(found);
    }
}

TEST_CASE("surface points lie on a floor to the last bit of its coordinate") {
    Scene scene = scene_of(
        {quad_mesh({glm::vec3(-50, -1, 100), {50, -1, 100}, {50, -1, 0.6f}, {-50, -1, 0.6f}}, {0, 1, 0})});
    scene.camera.near_plane = 0.5;
    const SurfacePoints points =
        surface_points(scene, scene.camera, normal_depth(scene, scene.camera, kSize));
    REQUIRE(points.points.size() > 500);
    for (const SurfacePoint& p : points.points) {
        CHECK(p.position.y == -1);
        CHECK(p.geometric_normal == glm::vec3(0, 1, 0));
    }
}

TEST_CASE(
    "surface points: the same bits far from the origin, at every thread count, lane count and tile size") {
    const Scene scene = still_life();
    const View view = views().back();
    const SurfacePoints points = surface_points(scene, view.camera, gbuffer_of(scene, view));
    for_every_run({.threads = {1, 7}, .tile_sizes = {16, 32}}, [&](const Run& run) {
        CHECK(same(points, surface_points(scene, view.camera, gbuffer_of(scene, view, run), run)));
    });
    Scene far = scene;
    View far_view = view;
    const glm::dvec3 shift(262144, -262144, 524288);
    for (Mesh& mesh : far.meshes) {
        for (glm::vec3& p : mesh.positions) p = glm::round(p * 16.0f) / 16.0f;
    }
    Scene near = far;
    far_view.camera.eye += shift;
    far_view.camera.target += shift;
    for (Instance& instance : far.instances) {
        for (int axis = 0; axis < 3; ++axis)
            instance.world_from_object[3][axis] += static_cast<float>(shift[axis]);
    }
    CHECK(same(surface_points(near, view.camera, gbuffer_of(near, view)),
               surface_points(far, far_view.camera, gbuffer_of(far, far_view))));
}

TEST_CASE("surface points: a pixel without a normal takes the triangle's; no surface, no points") {
    Scene scene = scene_of({facing_quad({0, 0, 4}, 1)});
    scene.meshes[0].normals.assign(4, glm::vec3(0));
    const SurfacePoints points =
        surface_points(scene, scene.camera, normal_depth(scene, scene.camera, kSize));
    REQUIRE(!points.points.empty());
    for (const SurfacePoint& p : points.points) CHECK(p.normal == p.geometric_normal);
    scene.camera.target = {0, 0, -1};
    CHECK(surface_points(scene, scene.camera, normal_depth(scene, scene.camera, kSize)).points.empty());
}

TEST_CASE("picture_of puts each value at its pixel") {
    SurfacePoints points{{3, 2}, std::vector<SurfacePoint>(2), {1, 5}};
    const Image<float> picture = picture_of(points, std::vector<float>{0.25f, 0.5f}, 1);
    CHECK(picture.at(0, 0) == 1);
    CHECK(picture.at(1, 0) == 0.25f);
    CHECK(picture.at(2, 1) == 0.5f);
    CHECK_THROWS_AS(picture_of(points, std::vector<float>{0.25f}), InputError);
}
