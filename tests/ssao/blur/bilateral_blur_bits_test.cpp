// The blur against the tutorials' loop in float, bit for bit: on every map, however it is run, whatever is
// left out.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/blur/bilateral_blur.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// Surfaces with steps and bends, and about a third sky, in patches of unlike sizes.
AoInputs patchy_inputs(Size size) {
    AoInputs inputs = plain_inputs(size, 5);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            inputs.view_depth.at(x, y) =
                5 + 0.12f * noise(41, x, y) + (noise(42, x / 13, y / 7) > 0.6f ? 1.0f : 0.0f);
            inputs.normal.set(x, y, glm::normalize(glm::vec3(noise(43, x / 5, y) - 0.5f, 0.2f, -0.8f)));
            if (noise(44, x / 19, y / 11) > 0.7f) {
                inputs.view_depth.at(x, y) = kInfinity;
                inputs.normal.set(x, y, glm::vec3(0));
            }
        }
    }
    return inputs;
}

// Open but for blocks of noise far from each other, and one dot.
Image<float> mostly_open_map(Size size) {
    Image<float> ao(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (noise(45, x / 24, y / 24) > 0.93f) ao.at(x, y) = noise(46, x, y);
        }
    }
    ao.at(size.width / 3, size.height / 2) = 0.25f;
    return ao;
}

float dot(glm::vec3 a, glm::vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// View space, as the map's rays have it.
glm::vec3 position(const AoInputs& inputs, glm::ivec2 texel) {
    const auto centre = [](int i, int count) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    };
    const Size size = inputs.size();
    const Vec3<float> ray =
        inputs.rays.p_view(centre(texel.x, size.width), centre(texel.y, size.height), 1.0f);
    const float z = inputs.view_depth.at(texel.x, texel.y), scale = inputs.rays.perspective ? z : 1.0f;
    return {ray.x * scale, ray.y * scale, z};
}

bool counts(const AoInputs& inputs, glm::ivec2 a, glm::ivec2 b, const BlurSettings& settings) {
    if (settings.edges == BlurEdges::none) return true;
    const glm::vec3 m = inputs.normal.at(a.x, a.y), n = inputs.normal.at(b.x, b.y);
    if (!(dot(m, n) >= settings.normal_threshold)) return false;
    const float limit = settings.depth_threshold;
    if (settings.edges == BlurEdges::fixed)
        return std::fabs(inputs.view_depth.at(a.x, a.y) - inputs.view_depth.at(b.x, b.y)) <= limit;
    const glm::vec3 way = position(inputs, b) - position(inputs, a);
    return std::fabs(dot(m, way)) <= limit && std::fabs(dot(n, way)) <= limit;
}

// One pass of the tutorials' loop; a texel that has only itself keeps its value.
Image<float> one_pass(const Image<float>& ao, const AoInputs& inputs, const BlurSettings& settings,
                      glm::ivec2 step) {
    Image<float> result = ao;
    const auto inside = [&](glm::ivec2 p) {
        return p.x >= 0 && p.y >= 0 && p.x < ao.size.width && p.y < ao.size.height;
    };
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            float total = settings.weights[5], sum = total * ao.at(x, y);
            bool alone = true;
            for (int k = -5; k <= 5; ++k) {
                const glm::ivec2 tap = glm::ivec2(x, y) + k * step;
                if (k == 0 || !inside(tap) || !counts(inputs, {x, y}, tap, settings)) continue;
                const float weight = settings.weights[static_cast<std::size_t>(k + 5)];
                alone = false;
                total += weight;
                sum += weight * ao.at(tap.x, tap.y);
            }
            if (!alone) result.at(x, y) = stored_as(sum / total, settings.format);
        }
    }
    return result;
}

Image<float> looped(Image<float> ao, const AoInputs& inputs, const BlurSettings& settings) {
    for (int i = 0; i < settings.iterations; ++i)
        ao = one_pass(one_pass(ao, inputs, settings, {1, 0}), inputs, settings, {0, 1});
    return ao;
}

// Every run, each with what it may keep.
std::vector<Run> all_runs() {
    std::vector<Run> runs;
    for (const KeptWork& kept : {KeptWork{}, KeptWork::only(Skip::open_tiles),
                                 KeptWork::only(Skip::background_pixels), KeptWork::all()}) {
        for (Run run : every_run({.threads = {1, 2, 7}})) {
            run.kept = kept;
            runs.push_back(run);
        }
    }
    return runs;
}

// "" when every run gives the loop's bits.
std::string unlike_the_loop(const Image<float>& ao, const AoInputs& inputs, const BlurSettings& settings) {
    const std::string expected = content_hash(looped(ao, inputs, settings));
    std::string unlike;
    for (const Run& run : all_runs()) {
        if (content_hash(bilateral_blur(ao, inputs, settings, run).ao) == expected) continue;
        unlike += run_text(run) + ", open tiles left out " +
                  std::to_string(run.leaves_out(Skip::open_tiles)) + " background left out " +
                  std::to_string(run.leaves_out(Skip::background_pixels)) + "; ";
    }
    return unlike;
}

}  // namespace

TEST_CASE("blur: the bits of the tutorials' loop, in every size, run in every way") {
    for (const Size size :
         {Size{1, 1}, {7, 3}, {3, 7}, {8, 8}, {9, 33}, {64, 5}, {37, 130}, {131, 96}, {1, 300}}) {
        for (const BlurSettings& settings : {kXjunBlur, kLunaBlur}) {
            CAPTURE(size.width);
            CAPTURE(size.height);
            CAPTURE(settings.iterations);
            CHECK(unlike_the_loop(noise_image(size, 36), patchy_inputs(size), settings) == "");
            CHECK(unlike_the_loop(mostly_open_map(size), patchy_inputs(size), settings) == "");
        }
    }
}

TEST_CASE("blur: the bits of the loop on one row of 32768 texels, and on one column") {
    for (const Size size : {Size{32768, 1}, {1, 32768}}) {
        CAPTURE(size.width);
        const BlurSettings once{.iterations = 1};
        const std::string expected = content_hash(looped(noise_image(size, 36), patchy_inputs(size), once));
        for (const int threads : {1, 2}) {
            Run run;
            run.threads = threads;
            CAPTURE(threads);
            CHECK(content_hash(bilateral_blur(noise_image(size, 36), patchy_inputs(size), once, run).ao) ==
                  expected);
        }
    }
}

// A sweep does eight iterations; one, a whole sweep, one more and many of them.
TEST_CASE("blur: the bits of the loop for every number of iterations") {
    const Size size = {45, 50};
    for (const int iterations : {1, 7, 8, 9, 17, 64}) {
        CAPTURE(iterations);
        const BlurSettings settings{.iterations = iterations};
        CHECK(unlike_the_loop(mostly_open_map(size), patchy_inputs(size), settings) == "");
    }
}

TEST_CASE("blur: the bits of the loop with buffers of 16 bits and with unlike thresholds and weights") {
    const Size size = {61, 40};
    BlurSettings lopsided;
    for (std::size_t k = 0; k < lopsided.weights.size(); ++k)
        lopsided.weights[k] = 0.01f + 0.07f * static_cast<float>(k);
    BlurSettings everything, flat_only, nearest_even, toward_zero;
    everything.normal_threshold = -1;
    everything.depth_threshold = 1e30f;
    flat_only.normal_threshold = 1;
    flat_only.depth_threshold = 0;
    nearest_even.format = BufferFormat::float16_nearest_even;
    toward_zero.format = BufferFormat::float16_toward_zero;
    const std::array settings = {lopsided, everything, flat_only, nearest_even, toward_zero};
    for (std::size_t i = 0; i < settings.size(); ++i) {
        CAPTURE(i);
        CHECK(unlike_the_loop(noise_image(size, 36), patchy_inputs(size), settings[i]) == "");
        CHECK(unlike_the_loop(mostly_open_map(size), patchy_inputs(size), settings[i]) == "");
    }
}

TEST_CASE("blur: the bits of the loop with either other test of edges, in both projections") {
    for (const Size size : {Size{1, 1}, {9, 33}, {37, 70}, {61, 40}, {131, 20}}) {
        for (const BlurEdges edges : {BlurEdges::slope, BlurEdges::none}) {
            for (const bool perspective : {false, true}) {
                CAPTURE(size.width);
                CAPTURE(static_cast<int>(edges));
                CAPTURE(perspective);
                AoInputs inputs = patchy_inputs(size);
                if (perspective) inputs.rays = {{0.9f, 0.6f}, size, true};
                BlurSettings settings{.iterations = 2, .normal_threshold = 0.7f, .edges = edges};
                CHECK(unlike_the_loop(noise_image(size, 36), inputs, settings) == "");
                CHECK(unlike_the_loop(mostly_open_map(size), inputs, settings) == "");
            }
        }
    }
}

TEST_CASE("blur: surfaces everywhere, nowhere, and only in one texel of a group") {
    const Size size = {48, 24};
    const Image<float> ao = noise_image(size, 36);
    AoInputs nothing = plain_inputs(size, 5);
    nothing.view_depth = Image<float>(size, kInfinity);
    nothing.normal = Image3(size, glm::vec3(0));
    CHECK(unlike_the_loop(ao, plain_inputs(size, 5), kXjunBlur) == "");
    CHECK(unlike_the_loop(ao, nothing, kXjunBlur) == "");
    CHECK(content_hash(bilateral_blur(ao, nothing).ao) == content_hash(ao));
    for (int x = 8; x < 24; ++x) {
        CAPTURE(x);
        AoInputs pair = nothing;
        for (const int column : {x, x + 5}) {
            pair.view_depth.at(column, 11) = 5;
            pair.normal.set(column, 11, {0, 0, -1});
        }
        CHECK(unlike_the_loop(ao, pair, BlurSettings{.iterations = 1}) == "");
    }
}

TEST_CASE("blur: weights whose sum is no number are refused") {
    BlurSettings settings;
    settings.weights.fill(1e38f);
    CHECK_THROWS_WITH_AS(bilateral_blur(noise_image({3, 3}, 36), plain_inputs({3, 3}, 5), settings),
                         doctest::Contains("blur weights"), UsageError);
    settings.weights.fill(1e37f);
    CHECK(other_than(bilateral_blur(Image<float>({9, 9}, 1), plain_inputs({9, 9}, 5), settings).ao, 1) == "");
}
