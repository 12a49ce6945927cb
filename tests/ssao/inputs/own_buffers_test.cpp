// AO of buffers that another program drew: gbuffer_of().
#include "rasterizer/draw/own_buffers.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "ssao/judge/metrics.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"
#include "tests/tools/error_message.h"

using namespace crevice;

TEST_CASE("own buffers: normals and view depth alone give the AO of the frame that they are from") {
    const Scene scene = find_builtin_scene("columns")->make();
    for (const bool reversed : {false, true}) {
        CAPTURE(reversed);
        Camera camera = scene.camera;
        camera.reversed_z = reversed;
        const GBuffer drawn = normal_depth(scene, camera, {159, 91});
        const GBuffer own = gbuffer_of(drawn.normal, drawn.view_depth, camera);
        CHECK(compare_images(own.normal, drawn.normal).differing_pixels == 0);
        CHECK(compare_images(ndc_depth(own.depth), ndc_depth(drawn.depth)).max_abs < 1e-6);
        // X_Jun's reads view depth; Luna's reads the ndc depth, whose last bits are others.
        CHECK(compare_images(xjun_ssao(own, camera).ao, xjun_ssao(drawn, camera).ao).identical());
        CHECK(compare_images(luna_ssao(own, camera).ao, luna_ssao(drawn, camera).ao).rmse < 0.01);
    }
}

TEST_CASE("own buffers: where no surface is normals count for nothing, and bad pixels are named") {
    const float infinity = std::numeric_limits<float>::infinity();
    const Size size = {3, 2};
    Image3 normal(size);
    for (Image<float>* plane : {&normal.x, &normal.y, &normal.z}) *plane = Image<float>(size, 0.5f);
    Image<float> view_depth(size, infinity);
    view_depth.at(1, 1) = 4;
    const GBuffer sky = gbuffer_of(normal, view_depth, Camera{});
    CHECK(sky.normal.x.at(0, 0) == 0);
    CHECK(sky.normal.x.at(1, 1) == 0.5f);
    CHECK(ndc_depth(sky.depth).at(0, 0) == 1);
    const auto message = [&] {
        return message_of<InputError>([&] { gbuffer_of(normal, view_depth, Camera{}); });
    };
    normal.z.at(1, 1) = std::nanf("");
    CHECK(contains(message(), "normal: not a finite number (nan) at pixel (1, 1)"));
    view_depth.at(2, 0) = -1;
    CHECK(contains(message(), "view_depth: not in front of the eye (-1) at pixel (2, 0)"));
    view_depth = Image<float>({2, 2}, 1.0f);
    CHECK(contains(message(), "3x2 and 2x2"));
}
