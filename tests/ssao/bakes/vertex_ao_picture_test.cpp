#include "ssao/bakes/vertex_ao_picture.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

VertexAo of_values(std::vector<float> values) {
    VertexAo ao;
    ao.accessibility = {std::move(values)};
    return ao;
}

}  // namespace

TEST_CASE("vertex ao picture: values are linear over a square that fills half of the picture; sky is open") {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        CAPTURE(static_cast<int>(projection));
        // Corners: upper left, upper right, lower right, lower left.
        Scene scene = scene_of({facing_quad({0, 0, 4}, 1)});
        scene.camera.projection = projection;
        scene.camera.fov_y_rad = 2 * std::atan(0.5);  // 4 high at distance 4
        scene.camera.ortho_height = 4;
        const RayScene rays = ray_scene(scene, scene.camera.eye);
        const Image<float> picture =
            vertex_ao_picture(scene, scene.camera, {32, 32}, rays, of_values({0.2f, 0.6f, 0.6f, 0.2f}));
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x) {
                const bool inside = x >= 8 && x < 24 && y >= 8 && y < 24;
                const double expected = inside ? 0.2 + 0.4 * (x + 0.5 - 8) / 16 : 1;
                CAPTURE(x);
                CAPTURE(y);
                CHECK(std::abs(static_cast<double>(picture.at(x, y)) - expected) < 1e-5);
            }
        }
    }
}

TEST_CASE("vertex ao picture: equal vertices make exactly that value; instances have values of their own") {
    Scene scene = scene_of({facing_quad({0, 0, 4}, 8)});
    scene.instances.push_back(scene.instances[0]);
    scene.instances[1].world_from_object[3] = {0, 0, 1, 1};  // behind the first
    const RayScene rays = ray_scene(scene, scene.camera.eye);
    VertexAo ao;
    ao.accessibility = {std::vector<float>(4, 0.3f), std::vector<float>(4, 0.9f)};
    const Image<float> picture = vertex_ao_picture(scene, scene.camera, {16, 16}, rays, ao);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) CHECK(picture.at(x, y) == 0.3f);
    }
    const RayScene elsewhere = ray_scene(scene, {1, 0, 0});
    CHECK_THROWS_AS(vertex_ao_picture(scene, scene.camera, {16, 16}, elsewhere, ao), UsageError);
}
