// What the visibility bitmask is for: light that passes behind thin things.
#include <doctest/doctest.h>

#include "scenes/shapes.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/judge/metrics.h"
#include "ssao/methods/gtao.h"
#include "ssao/methods/vbao.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/seen_ao.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

TEST_CASE("vbao: behind a fence it is nearer to ray casting than a horizon is, for any number of samples") {
    // Bars before a wall, much thinner than their distance to it.
    std::vector<Mesh> meshes = {facing_quad({0, 0, 6}, 6)};
    for (const float x : {-2.0f, -1.0f, 0.0f, 1.0f, 2.0f}) {
        Mesh bar = box_mesh({0.2, 8, 0.2});
        for (glm::vec3& p : bar.positions) p += glm::vec3(x, 0, 5);
        meshes.push_back(bar);
    }
    const Scene scene = scene_of(meshes);
    const Size size{120, 80};
    const float radius = 2;
    const SeenAo truth = seen_ao(scene, few_rays(radius, 256), size);
    const Image<float> expected = picture_of(truth.seen, truth.open);
    const GBuffer g = normal_depth(scene, scene.camera, size);
    // As thick as the default is beside the default radius.
    const VbaoSettings usual{.radius = radius, .thickness = radius / 4, .ao_scale = 1};
    const AoInputs inputs = ao_inputs(g, scene.camera, pixel_fetch(usual));
    const auto rmse = [&](VbaoSettings settings, int samples) {
        settings.samples = samples;
        return compare_images(vbao(inputs, settings).ao, expected).rmse;
    };
    VbaoSettings endless = usual, flat = usual;
    endless.thickness = 1e30f;
    flat.thickness = 0;
    for (const int samples : {8, 18, 54, 192}) {
        CAPTURE(samples);
        const double horizon =
            compare_images(gtao(inputs, {.samples = samples, .radius = radius, .ao_scale = 1}).ao, expected)
                .rmse;
        const double own = rmse(usual, samples);
        CAPTURE(own);
        CAPTURE(horizon);
        CHECK(own < 0.92 * horizon);
        CHECK(own < 0.8 * rmse(endless, samples));
    }
    CHECK(other_than(vbao(inputs, flat).ao, 1) == "");
}
