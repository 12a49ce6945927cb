// The numerical traps of the tutorials' listings, a test or more each. Those of half floats are in
// luna_formats_test.cpp, that of the blur's weights in bilateral_blur_test.cpp.
#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr Size kSize = {65, 65};

// What one offset contributes to a point in the middle of the picture, above it a sheet at depth `sheet`.
float sample_under(const AoInputs& inputs, const LunaSettings& settings, Vec3<float> p, Vec3<float> n,
                   glm::vec3 offset, Vec3<float> random = {0, 1, 0}) {
    return LunaKernel(inputs, settings).sample<float>(p, n, random, offset);
}

// Smallest accessibility, over all vectors of the random map, of a point that sees occluders only further
// away than `distance`.
float lowest_with_occluders_beyond(float distance, const LunaSettings& settings) {
    AoInputs inputs = plain_inputs(kSize, 10);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const float away = std::hypot(static_cast<float>(x - 32), static_cast<float>(y - 32));
            inputs.depth_map.at(x + 1, y + 1) = away > distance ? 9.5f : 20.0f;
        }
    }
    inputs.depth_map.at(0, 0) = 9.5f;
    const LunaKernel kernel(inputs, settings);
    const RandomMap map = random_map(settings.seed);
    float lowest = 1;
    for (int y = 0; y < kRandomMapSide; y += 2) {
        for (int x = 0; x < kRandomMapSide; x += 2) {
            const float u = (static_cast<float>(x) + 0.5f) / (kRandomMapRepeats * kRandomMapSide);
            const float v = (static_cast<float>(y) + 0.5f) / (kRandomMapRepeats * kRandomMapSide);
            const float a =
                kernel.accessibility<float>({0, 0, 10}, {0, 0, -1}, kernel.random_vector<float>(map, u, v));
            lowest = min_of(lowest, a);
        }
    }
    return lowest;
}

}  // namespace

TEST_CASE("trap 1: a random vector that is not unit makes offsets up to five times as long") {
    LunaSettings settings;
    const AoInputs inputs = plain_inputs({1, 1}, 10);
    const RandomMap map = random_map(settings.seed);
    double worst_gain = 0, mean_gain = 0, worst_published = 0;
    int count = 0;
    for (int i = 0; i < 4096; ++i) {
        const float u = noise(7, i, 0), v = noise(7, i, 1);
        for (const bool as_published : {false, true}) {
            settings.as_published = as_published;
            const Vec3<float> f = LunaKernel(inputs, settings).random_vector<float>(map, u, v);
            const double x = f.x, y = f.y, z = f.z, squared = x * x + y * y + z * z;
            // Along the vector the gain of the reflection is |1 - 2 r^2|, across it 1.
            const double gain = std::fabs(1 - 2 * squared);
            if (!as_published) {
                worst_gain = std::fmax(worst_gain, std::fabs(gain - 1));
                continue;
            }
            worst_published = std::fmax(worst_published, gain);
            mean_gain += gain;
            ++count;
        }
    }
    CHECK(worst_gain < 12.0 / 16777216);  // |r| is within 3u of 1, and counts four times
    CHECK(worst_published > 1.5);
    CHECK(worst_published <= 5);
    CHECK(mean_gain / count > 0.3);
}

TEST_CASE("trap 1: unit random vectors look no further than the radius, as published up to five radii") {
    LunaSettings settings;
    settings.exponent = 1;
    settings.radius = 6;
    // A bilinear read takes in pixels up to sqrt(2) away.
    const float one_radius = settings.radius + 1.5f, five_radii = 5 * settings.radius + 1.5f;
    CHECK(lowest_with_occluders_beyond(one_radius, settings) == 1);
    CHECK(lowest_with_occluders_beyond(settings.radius - 2, settings) < 1);
    settings.as_published = true;
    CHECK(lowest_with_occluders_beyond(one_radius, settings) < 1);
    CHECK(lowest_with_occluders_beyond(five_radii, settings) == 1);
}

TEST_CASE("trap 1: a point in front of the near plane contributes nothing") {
    AoInputs inputs = plain_inputs(kSize, 0.9f);
    LunaSettings settings;
    const glm::vec3 toward_eye(0, 0, -1);
    inputs.near_plane = 0.5;
    CHECK(sample_under(inputs, settings, {0, 0, 1.2f}, {0, 0, -1}, toward_eye) > 0.9f);
    inputs.near_plane = 1;
    CHECK(sample_under(inputs, settings, {0, 0, 1.2f}, {0, 0, -1}, toward_eye) == 0);
    // Behind the eye, where the projection would mirror it, and in the eye's plane, where it would divide by
    // 0.
    inputs.near_plane = 0.01f;
    inputs.rays.perspective = true;
    inputs.rays.ray_scale = glm::vec2(1);
    settings.radius = 1.2f;
    CHECK(sample_under(inputs, settings, {0, 0, 1.2f}, {0, 0, -1}, toward_eye) == 0);
    settings.radius = 3;
    CHECK(sample_under(inputs, settings, {0.1f, 0, 1.2f}, {0, 0, -1}, toward_eye) == 0);
}

TEST_CASE("trap 1: an eye 0.1 in front of a wall sees an open wall") {
    for (const TutorialMethod& method : kTutorialMethods) {
        for (const bool as_published : {false, true}) {
            CAPTURE(method.name);
            CAPTURE(as_published);
            Scene scene = scene_of({facing_quad({0, 0, 0.1f}, 1)});
            scene.camera.near_plane = 0.05;
            LunaSettings settings = method.settings;
            settings.as_published = as_published;
            const AoInputs facing =
                ao_inputs(normal_depth(scene, scene.camera, {33, 25}), scene.camera, method.fetch(settings));
            CHECK(other_than(luna_occlusion(facing, settings, {}).ao, 1) == "");
            scene.camera.target = {0.5, 0.5, 1};
            const AoInputs tilted =
                ao_inputs(normal_depth(scene, scene.camera, {33, 25}), scene.camera, method.fetch(settings));
            CHECK(outside_unit_interval(luna_occlusion(tilted, settings, {}).ao) == "");
        }
    }
}

TEST_CASE("trap 2: the sign of 0 is +1; as published it is 0 and the sample falls onto the point itself") {
    const AoInputs sheet = plain_inputs(kSize, 9.5f);
    LunaSettings settings;
    settings.radius = 1;
    // Across the normal at distance 1, the sheet half a unit in front: dp = .5 / sqrt(1.25), occlusion (2 -
    // .5) / 1.8.
    const float across = sample_under(sheet, settings, {0, 0, 10}, {0, 0, -1}, {1, 0, 0});
    CHECK(std::fabs(static_cast<double>(across) - 0.5 / std::sqrt(1.25) * 1.5 / 1.8) < 1e-6);
    // The side is the offset's own, not the opposite one.
    AoInputs half_sheet = sheet;
    for (int y = 0; y < half_sheet.depth_map.size.height; ++y) {
        for (int x = 0; x < 33; ++x) half_sheet.depth_map.at(x, y) = 20;
    }
    CHECK(sample_under(half_sheet, settings, {0, 0, 10}, {0, 0, -1}, {1, 0, 0}) == across);
    CHECK(sample_under(half_sheet, settings, {0, 0, 10}, {0, 0, -1}, {-1, 0, 0}) == 0);
    settings.as_published = true;
    const float onto_itself = sample_under(sheet, settings, {0, 0, 10}, {0, 0, -1}, {1, 0, 0});
    CHECK(std::fabs(static_cast<double>(onto_itself) - 1.5 / 1.8) < 1e-6);
}

TEST_CASE("trap 2: offsets of length 0, samples that meet the point itself, normals 0 and NaN contribute 0") {
    const AoInputs surface = plain_inputs(kSize, 10), sheet = plain_inputs(kSize, 9.5f);
    for (const bool as_published : {false, true}) {
        CAPTURE(as_published);
        LunaSettings settings;
        settings.epsilon = 0;
        settings.as_published = as_published;
        const Vec3<float> p = {0, 0, 10};
        CHECK(sample_under(surface, settings, p, {0, 0, -1}, {0, 0, 0}) == 0);
        CHECK(sample_under(surface, settings, p, {0, 0, -1}, {0, 0, 1}) == 0);
        // |r|^2 = 1/2 along the offset: the reflection vanishes.
        CHECK(sample_under(surface, settings, p, {0, 0, -1}, {1, 0, 0}, {std::sqrt(0.5f), 0, 0}) == 0);
        CHECK(sample_under(sheet, settings, p, {0, 0, 0}, {0, 0, 1}) == 0);
        CHECK(sample_under(sheet, settings, p, {kNan, 0, 0}, {0, 0, 1}) == 0);
        CHECK(sample_under(sheet, settings, p, {0, 0, -1}, {0, 0, 1}, {kNan, kNan, kNan}) == 0);
    }
}

TEST_CASE("trap 5: fade end = fade start is a step") {
    LunaSettings settings;
    settings.fade_start = settings.fade_end = 1;
    const AoInputs inputs = plain_inputs({1, 1}, 10);
    const LunaKernel kernel(inputs, settings);
    CHECK(kernel.occlusion(std::nextafter(1.0f, 0.0f)) == 1);
    CHECK(kernel.occlusion(0.06f) == 1);
    CHECK(kernel.occlusion(1.0f) == 0);
    CHECK(kernel.occlusion(std::nextafter(1.0f, 2.0f)) == 0);
    CHECK(kernel.occlusion(0.05f) == 0);  // epsilon itself does not count
    CHECK(kernel.occlusion(kNan) == 0);
    CHECK(kernel.occlusion(kInfinity) == 0);
    CHECK(kernel.occlusion(-kInfinity) == 0);
}

TEST_CASE("trap 7: a sum above 1, as from long normals, gives 0 and no power of a negative number") {
    AoInputs inputs = plain_inputs({9, 9}, 10);
    for (float& z : inputs.depth_map.pixels) z = 9.5f;
    inputs.normal = Image3({9, 9}, {0, 0, -20});
    for (const float exponent : {0.5f, 1.0f, 4.0f, 6.0f}) {
        CAPTURE(exponent);
        LunaSettings settings;
        settings.exponent = exponent;
        CHECK(LunaKernel(inputs, settings).accessibility<float>({0, 0, 10}, {0, 0, -20}, {0, 1, 0}) < 0);
        CHECK(other_than(luna_occlusion(inputs, settings, {}).ao, 0) == "");
    }
}
