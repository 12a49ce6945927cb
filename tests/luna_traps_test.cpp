// The numerical traps of the tutorials' listings, one test each, in the order in which the listings meet them.
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/image_summary.h"
#include "ssao/bilateral_blur.h"
#include "tests/test_scenes.h"

using namespace crevice;

namespace {

constexpr Size kSize = {65, 65};
constexpr BufferFormat kFormats[] = {BufferFormat::float32, BufferFormat::float16_toward_zero,
                                     BufferFormat::float16_nearest_even};

// What one offset contributes to a point in the middle of the picture, above it a sheet at depth `sheet`.
float sample_under(const AoInputs& inputs, const LunaSettings& settings, Vec3<float> p, Vec3<float> n, glm::vec3 offset,
                   Vec3<float> random = {0, 1, 0}) {
    return LunaKernel(inputs, settings).sample<float>(p, n, random, offset);
}

// Smallest accessibility, over all vectors of the random map, of a point that sees occluders only further away than `distance`.
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
            const float a = kernel.accessibility<float>({0, 0, 10}, {0, 0, -1}, kernel.random_vector<float>(map, u, v));
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
    // Behind the eye, where the projection would mirror it, and in the eye's plane, where it would divide by 0.
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
            const AoInputs facing = ao_inputs(normal_depth(scene, scene.camera, {33, 25}), scene.camera, method.fetch(settings));
            CHECK(other_than(luna_occlusion(facing, settings, {}), 1) == "");
            scene.camera.target = {0.5, 0.5, 1};
            const AoInputs tilted = ao_inputs(normal_depth(scene, scene.camera, {33, 25}), scene.camera, method.fetch(settings));
            CHECK(outside_unit_interval(luna_occlusion(tilted, settings, {})) == "");
        }
    }
}

TEST_CASE("trap 2: the sign of 0 is +1; as published it is 0 and the sample falls onto the point itself") {
    const AoInputs sheet = plain_inputs(kSize, 9.5f);
    LunaSettings settings;
    settings.radius = 1;
    // Across the normal at distance 1, the sheet half a unit in front: dp = .5 / sqrt(1.25), occlusion (2 - .5) / 1.8.
    const float across = sample_under(sheet, settings, {0, 0, 10}, {0, 0, -1}, {1, 0, 0});
    CHECK(std::fabs(static_cast<double>(across) - 0.5 / std::sqrt(1.25) * 1.5 / 1.8) < 1e-6);
    settings.as_published = true;
    const float onto_itself = sample_under(sheet, settings, {0, 0, 10}, {0, 0, -1}, {1, 0, 0});
    CHECK(std::fabs(static_cast<double>(onto_itself) - 1.5 / 1.8) < 1e-6);
}

TEST_CASE("trap 2: an offset of length 0, a sample that meets the point itself, and normals 0 and NaN contribute 0") {
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
                    const Image<float> raw = luna_occlusion(inputs, settings, {});
                    BlurSettings blur;
                    blur.format = ao_format;
                    const Image<float> blurred = bilateral_blur(raw, inputs, blur);
                    CHECK(outside_unit_interval(raw) == "");
                    CHECK(outside_unit_interval(blurred) == "");
                    CHECK(buffer_statistics(raw).min < 0.9f);
                    // As published, seed 000's sky beside a silhouette sees its own depth mixed with the surface's.
                    if (as_published && method.name == "xjun") continue;
                    const AoInputs seen = ao_inputs(g, scene.camera, {inputs.fetch.depth, false, 0.5f, false});
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

TEST_CASE("trap 3: the sky's 1e5 as a half is 65504 where D3D truncates; rounded to nearest only the published text gets infinity") {
    Scene scene = still_life();
    scene.camera.far_plane = 1000;
    const auto background = [&](BufferFormat format, bool as_published) {
        NormalDepthSettings settings;
        settings.buffer_format = format;
        const GBuffer g = normal_depth(scene, scene.camera, {8, 8}, settings);
        return ao_inputs(g, scene.camera, {DepthSource::view_depth, false, 0.5f, as_published}).depth_map.at(0, 0);
    };
    for (const bool as_published : {false, true}) {
        CHECK(background(BufferFormat::float32, as_published) == 1e5f);
        CHECK(background(BufferFormat::float16_toward_zero, as_published) == 65504);
    }
    CHECK(background(BufferFormat::float16_nearest_even, false) == 65504);
    CHECK(background(BufferFormat::float16_nearest_even, true) == kInfinity);
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

TEST_CASE("trap 6: the step of a half float's view depth grows from .0078 to .25, and D3D stores it too near") {
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

TEST_CASE("trap 7: a sum above 1, as from normals longer than 1, gives 0 and not the power of a negative number") {
    AoInputs inputs = plain_inputs({9, 9}, 10);
    for (float& z : inputs.depth_map.pixels) z = 9.5f;
    inputs.normal = Image3({9, 9}, {0, 0, -20});
    for (const float exponent : {0.5f, 1.0f, 4.0f, 6.0f}) {
        CAPTURE(exponent);
        LunaSettings settings;
        settings.exponent = exponent;
        CHECK(LunaKernel(inputs, settings).accessibility<float>({0, 0, 10}, {0, 0, -20}, {0, 1, 0}) < 0);
        CHECK(other_than(luna_occlusion(inputs, settings, {}), 0) == "");
    }
}
