// G-buffers and inputs of the AO passes, from the still life and made by hand.
#pragma once

#include <cmath>
#include <string>

#include "rasterizer/draw/normal_depth.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

namespace crevice {

// The two methods that share the estimator, without the command line's table.
struct TutorialMethod {
    std::string name;
    LunaSettings settings;
    AoFetch (*fetch)(const LunaSettings&);
};
inline const TutorialMethod kTutorialMethods[] = {{"xjun", kXjunSettings, xjun_fetch},
                                                  {"luna", kLunaSettings, luna_fetch}};

// The still life, ready for the estimator, without contrast.
struct PreparedStillLife {
    // Powers of two: texture coordinates are exact in float, and a reference in double reads the random map
    // at the same place.
    static constexpr Size kSize = {128, 64};
    Scene scene = still_life();
    GBuffer g;
    AoInputs inputs;
    LunaSettings settings;

    explicit PreparedStillLife(const TutorialMethod& method) : settings(method.settings) {
        settings.exponent = 1;
        g = normal_depth(scene, scene.camera, kSize);
        inputs = ao_inputs(g, scene.camera, method.fetch(settings));
    }
};

// AO inputs made by hand: orthographic, one scene unit a pixel, AO map and depth map of picture size, view
// depth `z` everywhere in both, normals to the eye, far plane beyond everything outside.
inline AoInputs plain_inputs(Size size, float z) {
    AoInputs inputs;
    inputs.fetch = {DepthSource::view_depth, false, 1.0f};
    inputs.picture = size;
    inputs.normal = Image3(size, {0, 0, -1});
    inputs.view_depth = Image<float>(size, z);
    inputs.depth_map = Image<float>({size.width + 3, size.height + 3}, 1e5f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) inputs.depth_map.at(x + 1, y + 1) = z;
    }
    inputs.rays = {0.5f * glm::vec2(size.width, size.height), size, false};
    inputs.near_plane = 1;
    return inputs;
}

// The camera that made_up_gbuffer() sees through: near .5, far 100, 60 degrees.
inline Camera made_up_camera() { return still_life().camera; }

// Unlike values in every pixel, all of them multiples of 1/64, so that the sum of four is exact; `sky_share`
// of them sky.
inline GBuffer made_up_gbuffer(Size size, float sky_share) {
    const Camera camera = made_up_camera();
    const CameraMatrices m = camera_matrices(camera, size);
    GBuffer g{Image3(size, glm::vec3(0)), Image<float>(size, kInfinity),
              cleared_depth(size, DepthFormat::d32f, false)};
    const auto dyadic = [](float a) { return std::floor(a * 64) / 64; };
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (noise(1, x, y) < sky_share) continue;
            const float z = 2 + dyadic(8 * noise(2, x, y));
            g.view_depth.at(x, y) = z;
            g.depth.codes.at(x, y) = depth_code(DepthFormat::d32f, m.depth_a + m.depth_b / z, 0.0);
            g.normal.set(
                x, y,
                {dyadic(noise(3, x, y)), dyadic(noise(4, x, y)) - 0.5f, -dyadic(noise(5, x, y)) - 0.25f});
        }
    }
    return g;
}

}  // namespace crevice
