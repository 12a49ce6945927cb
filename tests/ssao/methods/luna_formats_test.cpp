// The traps of the tutorials' listings that come from storing depths and AO as half floats, and from the sky.
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "ssao/blur/bilateral_blur.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr BufferFormat kFormats[] = {BufferFormat::float32, BufferFormat::float16_toward_zero,
                                     BufferFormat::float16_nearest_even};

}  // namespace

TEST_CASE("traps 3 and 4: no NaN from 1e5 in half floats, and the sky is exactly open") {
    Scene scene = still_life();
    scene.camera.far_plane = 1000;
    for (const TutorialMethod& method : kTutorialMethods) {
        for (const BufferFormat buffers : kFormats) {
            NormalDepthSettings in_format;
            in_format.buffer_format = buffers;
            const GBuffer g = normal_depth(scene, scene.camera, {45, 30}, in_format);
            for (const BufferFormat ao_format : kFormats) {
                for (const bool as_published : {false, true}) {
                    CAPTURE(method.name);
                    CAPTURE(static_cast<int>(buffers));
                    CAPTURE(static_cast<int>(ao_format));
                    CAPTURE(as_published);
                    LunaSettings settings = method.settings;
                    settings.format = ao_format;
                    settings.as_published = as_published;
                    const AoInputs inputs = ao_inputs(g, scene.camera, method.fetch(settings));
                    const Image<float> raw = luna_occlusion(inputs, settings, {}).ao;
                    BlurSettings blur;
                    blur.format = ao_format;
                    const Image<float> blurred = bilateral_blur(raw, inputs, blur).ao;
                    CHECK(outside_unit_interval(raw) == "");
                    CHECK(outside_unit_interval(blurred) == "");
                    CHECK(buffer_statistics(raw).min < 0.9f);
                    // As published, X_Jun's sky beside a silhouette sees its own depth mixed with the
                    // surface's.
                    if (as_published && method.name == "xjun") continue;
                    const AoInputs seen = ao_inputs(g, scene.camera, {inputs.fetch.depth, false, 0.5f});
                    int sky = 0;
                    CHECK(pixels_against(raw.size, [&](int x, int y) {
                              if (seen.view_depth.at(x, y) < kInfinity) return true;
                              ++sky;
                              return raw.at(x, y) == 1 && blurred.at(x, y) == 1;
                          }) == "");
                    CHECK(sky > 100);
                }
            }
        }
    }
}

TEST_CASE("trap 3: 1e5 as a half is 65504, or infinity where it is stored rounded to nearest") {
    Scene scene = still_life();
    scene.camera.far_plane = 1000;
    const auto background = [&](BufferFormat format, SkyDepth sky) {
        NormalDepthSettings settings;
        settings.buffer_format = format;
        const GBuffer g = normal_depth(scene, scene.camera, {8, 8}, settings);
        return ao_inputs(g, scene.camera, {.sky_depth = sky}).depth_map.at(0, 0);
    };
    for (const SkyDepth sky : {SkyDepth::finite, SkyDepth::as_stored}) {
        CHECK(background(BufferFormat::float32, sky) == 1e5f);
        CHECK(background(BufferFormat::float16_toward_zero, sky) == 65504);
    }
    CHECK(background(BufferFormat::float16_nearest_even, SkyDepth::finite) == 65504);
    CHECK(background(BufferFormat::float16_nearest_even, SkyDepth::as_stored) == kInfinity);
}

TEST_CASE(
    "trap 6: the step of a half float's view depth grows from .0078 to .25, and D3D stores it too near") {
    double step = 0.0078125;
    for (float low = 8; low < 512; low *= 2, step *= 2) {
        CAPTURE(low);
        for (int i = 0; i < 64; ++i) {
            const float z = low * (1 + noise(11, i, static_cast<int>(low)));
            CAPTURE(z);
            const double stored = stored_as(z, BufferFormat::float16_toward_zero), exact = z;
            CHECK(stored == std::floor(exact / step) * step);
            const double nearest = stored_as(z, BufferFormat::float16_nearest_even);
            CHECK(std::fabs(nearest - exact) <= step / 2);
        }
        // What a surface of the buffer gets: at most the step nearer than it is.
        Scene scene = scene_of({facing_quad({0, 0, low * 1.37f}, low)});
        NormalDepthSettings settings;
        settings.buffer_format = BufferFormat::float16_toward_zero;
        const double seen = normal_depth(scene, scene.camera, {8, 8}, settings).view_depth.at(4, 4);
        const double exact = low * 1.37f;
        CHECK(seen <= exact * (1 + 1e-6));
        CHECK(seen > exact * (1 - 1e-6) - step);
    }
}
