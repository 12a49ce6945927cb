#include "ssao/methods/luna_occlusion.h"

#include <cmath>
#include <functional>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
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

struct AoMaps {
    Image<float> raw, blurred;
};
AoMaps ao_maps(const Scene& scene, Size size, const TutorialMethod& method, const LunaSettings& settings,
               const BlurSettings& blur = {}) {
    const AoInputs inputs =
        ao_inputs(normal_depth(scene, scene.camera, size), scene.camera, method.fetch(settings));
    Image<float> raw = luna_occlusion(inputs, settings, {}).ao;
    Image<float> blurred = bilateral_blur(raw, inputs, blur).ao;
    return {std::move(raw), std::move(blurred)};
}

// A near pillar before a wall a thousand times as far, and sky: the steepest silhouettes.
Scene pillar_before_far_wall() {
    Scene scene = scene_of({facing_quad({-0.3f, 0, 1.2f}, 0.3f), facing_quad({100, -200, 900}, 300)});
    scene.camera.near_plane = 1;
    scene.camera.far_plane = 1000;
    return scene;
}

}  // namespace

TEST_CASE("a plane that faces the eye is exactly open, near and far, also at the border of the picture") {
    for (const float z : {1.5f, 4.0f, 13.7f, 450.0f}) {
        for (const Size size : {Size{1, 1}, {8, 8}, {37, 23}}) {
            CAPTURE(z);
            CAPTURE(size.width);
            AoInputs inputs = plain_inputs(size, z);
            CHECK(other_than(luna_occlusion(inputs, {}, {}).ao, 1) == "");
            inputs.rays.perspective = true;
            inputs.rays.ray_scale = {0.7f, 0.5f};
            CHECK(other_than(luna_occlusion(inputs, {}, {}).ao, 1) == "");
        }
    }
}

TEST_CASE("closed form: a sheet half a unit in front of a plane") {
    // Orthographic, so that all samples see the sheet straight ahead: dp = .5 / sqrt(R^2 (d_x^2 + d_y^2) +
    // .25), and the occlusion of half a unit is (2 - .5) / (2 - .2).
    const Size size = {64, 64};
    AoInputs inputs = plain_inputs(size, 10);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) inputs.depth_map.at(x + 1, y + 1) = 9.5f;
    }
    LunaSettings settings;
    settings.radius = 4;
    settings.seed = 77;
    const auto offsets = cube_offsets(settings.seed);
    const RandomMap map = random_map(settings.seed);
    // At 64 texels a side the random map, four times across, is read in the middle of four texels: 16 x + 7
    // and the next.
    const auto random_at = [&](int x, int y) {
        glm::dvec3 sum(0);
        for (int i = 0; i < 4; ++i) {
            const auto at =
                static_cast<std::size_t>((16 * y + 7 + i / 2) % 256 * 256 + (16 * x + 7 + i % 2) % 256);
            sum += glm::dvec3(map.x[at], map.y[at], map.z[at]);
        }
        return glm::normalize(sum);
    };
    for (const int samples : {1, 3, 14}) {
        for (const float exponent : {1.0f, 4.0f}) {
            CAPTURE(samples);
            CAPTURE(exponent);
            settings.samples = samples;
            settings.exponent = exponent;
            const Image<float> ao = luna_occlusion(inputs, settings, {}).ao;
            CHECK(pixels_against(size, [&](int x, int y) {
                      if (x < 6 || y < 6 || x > 57 || y > 57) return true;  // may see the border
                      double sum = 0;
                      for (int i = 0; i < samples; ++i) {
                          const glm::dvec3 d =
                              glm::reflect(glm::dvec3(offsets[static_cast<std::size_t>(i)]), random_at(x, y));
                          sum += 0.5 / std::sqrt(16 * (d.x * d.x + d.y * d.y) + 0.25) * (2 - 0.5) / (2 - 0.2);
                      }
                      const double expected = std::pow(1 - sum / samples, static_cast<double>(exponent));
                      return std::fabs(static_cast<double>(ao.at(x, y)) - expected) < 1e-5;
                  }) == "");
        }
    }
}

TEST_CASE("the depth map is read as a linear sampler with border reads it") {
    const Size size = {4, 3};
    AoInputs inputs = plain_inputs(size, 0);
    const LunaSettings settings;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) inputs.depth_map.at(x + 1, y + 1) = noise(21, x, y);
    }
    const LunaKernel kernel(inputs, settings);
    const auto border = inputs.depth_map.at(0, 0);
    const auto texel = [&](int x, int y) {
        return x < 0 || y < 0 || x >= 4 || y >= 3 ? border : noise(21, x, y);
    };
    for (int y = -1; y <= 3; ++y) {
        for (int x = -1; x <= 4; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            const Screen2<float> centre = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            CHECK(kernel.depth_at(centre) == texel(x, y));
            if (x == 4 || y == 3) continue;
            const double mean =
                (static_cast<double>(texel(x, y)) + static_cast<double>(texel(x + 1, y)) +
                 static_cast<double>(texel(x, y + 1)) + static_cast<double>(texel(x + 1, y + 1))) /
                4;
            const double between = kernel.depth_at(Screen2<float>{centre.x + 0.5f, centre.y + 0.5f});
            CHECK(std::fabs(between - mean) <= 1e-6 * mean);
        }
    }
    for (const float far : {-1e30f, -100.0f, 100.0f, 1e30f, kInfinity, -kInfinity, kNan}) {
        CAPTURE(far);
        CHECK(kernel.depth_at(Screen2<float>{far, 1.5f}) == border);
        CHECK(kernel.depth_at(Screen2<float>{1.5f, far}) == border);
    }
}

TEST_CASE("radius 0, and epsilon beyond the end of the fade: exactly open") {
    for (const TutorialMethod& method : kTutorialMethods) {
        for (const Scene& scene : {still_life(), pillar_before_far_wall()}) {
            for (const Size size : {Size{64, 48}, {45, 31}}) {
                for (const bool as_published : {false, true}) {
                    CAPTURE(method.name);
                    CAPTURE(scene.camera.far_plane);
                    CAPTURE(size.width);
                    CAPTURE(as_published);
                    LunaSettings settings = method.settings;
                    settings.as_published = as_published;
                    settings.epsilon = 2.5f;
                    const AoMaps beyond = ao_maps(scene, size, method, settings);
                    CHECK(other_than(beyond.raw, 1) == "");
                    CHECK(other_than(beyond.blurred, 1) == "");
                    settings.epsilon = 0.05f;
                    settings.radius = 0;
                    CHECK(other_than(ao_maps(scene, size, method, settings).raw, 1) == "");
                }
            }
        }
    }
}

TEST_CASE("any size and any setting that is accepted: finite, in [0, 1]") {
    const auto holds = [](const Scene& scene, Size size, const TutorialMethod& method,
                          const LunaSettings& settings) {
        const AoMaps maps = ao_maps(scene, size, method, settings);
        CHECK(maps.raw.size == ao_map_size(size, settings.ao_scale));
        CHECK(outside_unit_interval(maps.raw) == "");
        CHECK(outside_unit_interval(maps.blurred) == "");
    };
    const Scene scene = still_life();
    for (const TutorialMethod& method : kTutorialMethods) {
        CAPTURE(method.name);
        for (const Size size : {Size{1, 1}, {1, 64}, {3, 5}, {801, 601}, {32768, 1}}) {
            CAPTURE(size.width);
            CAPTURE(size.height);
            holds(scene, size, method, method.settings);
        }
        const std::function<void(LunaSettings&)> changes[] = {
            [](LunaSettings& s) { s.radius = 100; },
            [](LunaSettings& s) { s.radius = 1e30f; },
            [](LunaSettings& s) { s.radius = 3e38f; },
            [](LunaSettings& s) { s.radius = 1e-38f; },
            [](LunaSettings& s) { s.samples = 1; },
            [](LunaSettings& s) { s.fade_start = s.fade_end; },
            [](LunaSettings& s) { s.fade_start = s.fade_end = 0; },
            [](LunaSettings& s) { s.fade_start = 0, s.fade_end = 1e-40f, s.epsilon = 0; },
            [](LunaSettings& s) { s.fade_end = 3e38f; },
            [](LunaSettings& s) { s.epsilon = 3e38f; },
            [](LunaSettings& s) { s.exponent = 0; },
            [](LunaSettings& s) { s.exponent = 64; },
            [](LunaSettings& s) { s.ao_scale = 1; },
            [](LunaSettings& s) { s.seed = 0xffffffffu; },
        };
        int index = 0;
        for (const auto& change : changes) {
            for (const bool as_published : {false, true}) {
                CAPTURE(index);
                CAPTURE(as_published);
                LunaSettings settings = method.settings;
                settings.as_published = as_published;
                change(settings);
                holds(scene, {29, 22}, method, settings);
            }
            ++index;
        }
    }
}

TEST_CASE("settings out of their range are refused by name") {
    const auto refused = [](const char* name, const std::function<void(LunaSettings&)>& change) {
        CAPTURE(name);
        LunaSettings settings;
        change(settings);
        CHECK_THROWS_WITH_AS(validate(settings), doctest::Contains(name), UsageError);
        const AoInputs inputs = plain_inputs({2, 2}, 5);
        CHECK_THROWS_WITH_AS(luna_occlusion(inputs, settings, {}), doctest::Contains(name), UsageError);
    };
    for (const int samples : {0, -1, 15}) refused("samples: ", [=](LunaSettings& s) { s.samples = samples; });
    for (const float bad : {-0.1f, kNan, kInfinity, -kInfinity}) {
        CAPTURE(bad);
        refused("radius: ", [=](LunaSettings& s) { s.radius = bad; });
        refused("fade_start: ", [=](LunaSettings& s) { s.fade_start = bad; });
        refused("fade_end: ", [=](LunaSettings& s) { s.fade_end = bad; });
        refused("epsilon: ", [=](LunaSettings& s) { s.epsilon = bad; });
        refused("exponent: ", [=](LunaSettings& s) { s.exponent = bad; });
    }
    refused("exponent: ", [](LunaSettings& s) { s.exponent = 64.5f; });
    refused("fade_end: ", [](LunaSettings& s) { s.fade_start = 1, s.fade_end = 0.5f; });
    CHECK_NOTHROW(validate(kXjunSettings));
    CHECK_NOTHROW(validate(kLunaSettings));
}

TEST_CASE("all lengths times 2^k: the same bits") {
    for (const TutorialMethod& method : kTutorialMethods) {
        AoMaps one;
        for (const int k :
             {0, -20, -19, -18, -17, -16, -15, -14, -13, -12, -11, -10, -9, -8, -7, -6, -5, -4, -3, -2, -1,
              1, 2,   3,   4,   5,   6,   7,   8,   9,   10,  11,  12,  13, 14, 15, 16, 17, 18, 19, 20}) {
            CAPTURE(method.name);
            CAPTURE(k);
            LunaSettings settings = method.settings;
            BlurSettings blur;
            for (float* length : {&settings.radius, &settings.fade_start, &settings.fade_end,
                                  &settings.epsilon, &blur.depth_threshold}) {
                *length = std::ldexp(*length, k);
            }
            const AoMaps maps = ao_maps(scaled(still_life(), k), {48, 33}, method, settings, blur);
            if (k == 0) one = maps;
            CHECK(further_apart_than(0, maps.raw, one.raw) == "");
            CHECK(further_apart_than(0, maps.blurred, one.blurred) == "");
        }
        CHECK(buffer_statistics(one.raw).min < 0.5f);
    }
}
