// Temporal accumulation: what a camera at rest gains, what is refused, the clamp, the same bits.
#include "ssao/blur/temporal_accumulation.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/ao_methods.h"
#include "ssao/judge/metrics.h"
#include "tests/tools/every_run.h"
#include "tests/tools/flat_scenes.h"
#include "tests/tools/history_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/still_life.h"

using namespace crevice;

TEST_CASE(
    "temporal accumulation: at rest it is the mean over seeds, and its noise falls as one over the root of "
    "n") {
    const Scene scene = still_life();
    const GBuffer g = normal_depth(scene, scene.camera, kHistorySize);
    const Method& method = find_method("xjun");
    const MethodSettings settings = defaults_of(method);
    const auto map_of = [&](int seed) {
        return method.ao({scene, scene.camera, g, nullptr}, with_value(method, settings, "seed", seed).ao,
                         {});
    };
    constexpr int kMany = 1024;
    AoHistory history;
    Image<float> at_16, at_64;
    std::vector<double> sums;
    for (int frame = 0; frame < kMany; ++frame) {
        const RawAo raw = map_of(frame);
        history = temporal_accumulation(raw.ao, raw.inputs, scene.camera, history, {.longest = kMany});
        sums.resize(raw.ao.pixels.size());
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += static_cast<double>(raw.ao.pixels[i]);
        if (frame + 1 == 16) at_16 = history.ao;
        if (frame + 1 == 64) at_64 = history.ao;
    }
    CHECK(pixels_against(history.ao.size, [&](int x, int y) {
              const std::size_t i = static_cast<std::size_t>(y * history.ao.stride + x);
              const bool surface = history.view_depth.at(x, y) < std::numeric_limits<float>::infinity();
              return history.frames.at(x, y) == (surface ? kMany : 0) &&
                     std::fabs(double{history.ao.at(x, y)} - sums[i] / kMany) < 1e-5;
          }) == "");
    const double after_16 = compare_images(at_16, history.ao).rmse,
                 after_64 = compare_images(at_64, history.ao).rmse;
    CAPTURE(after_16);
    CAPTURE(after_64);
    // Against a mean of n frames of its own, m of N frames err by sigma sqrt(1/m - 1/N).
    CHECK(after_16 / after_64 ==
          doctest::Approx(std::sqrt((1.0 / 16 - 1.0 / kMany) / (1.0 / 64 - 1.0 / kMany))).epsilon(0.1));
}

TEST_CASE("temporal accumulation: the past fades exponentially from `longest` frames on") {
    const Scene scene = tilted_plane(0);
    const AoInputs inputs = inputs_of(scene, scene.camera);
    AoHistory history;
    double expected = 0;
    for (int frame = 0; frame < 12; ++frame) {
        const float now = frame % 3 == 0 ? 0.25f : 0.75f;
        history = temporal_accumulation(Image<float>(kHistorySize, now), inputs, scene.camera, history,
                                        {.longest = 4});
        expected += (static_cast<double>(now) - expected) / std::min(frame + 1, 4);
        CAPTURE(frame);
        CHECK(values_against(history.ao, [&](float a) { return std::fabs(double{a} - expected) < 1e-6; }) ==
              "");
        CHECK(other_than(history.frames, static_cast<float>(std::min(frame + 1, 4))) == "");
    }
}

TEST_CASE("temporal accumulation: what faces another way is another surface") {
    // The inner corner of two walls, seen from the left and then from the right: the planes meet where both are near.
    const Scene scene = wall_on_floor(3);
    const AoInputs inputs = inputs_of(scene, scene.camera);
    AoHistory before =
        temporal_accumulation(Image<float>(kHistorySize, 0.25f), inputs, scene.camera, {}, {.longest = 4});
    for (int y = 0; y < kHistorySize.height; ++y) {
        for (int x = 0; x < kHistorySize.width; ++x) before.normal.set(x, y, glm::vec3(0, 0, 1));
    }
    const AoHistory after = temporal_accumulation(Image<float>(kHistorySize, 0.75f), inputs, scene.camera,
                                                  before, {.longest = 4});
    CHECK(pixels_against(kHistorySize, [&](int x, int y) { return after.frames.at(x, y) <= 1; }) == "");
    const AoHistory any = temporal_accumulation(Image<float>(kHistorySize, 0.75f), inputs, scene.camera,
                                                before, {.longest = 4, .normal = -1});
    CHECK(pixels_against(kHistorySize, [&](int x, int y) {
              const bool surface = inputs.view_depth.at(x, y) < std::numeric_limits<float>::infinity();
              return any.frames.at(x, y) == (surface ? 2 : 0);
          }) == "");
}

TEST_CASE("temporal accumulation: a ghost fades by 1 / longest a frame") {
    const Scene scene = tilted_plane(0);
    const AoInputs inputs = inputs_of(scene, scene.camera);
    // What darkened everything is gone from one frame to the next.
    AoHistory history;
    for (int frame = 0; frame < 20; ++frame)
        history = temporal_accumulation(Image<float>(kHistorySize, 0.0f), inputs, scene.camera, history,
                                        {.longest = 8});
    for (int frame = 1; frame <= 24; ++frame) {
        history = temporal_accumulation(Image<float>(kHistorySize, 1.0f), inputs, scene.camera, history,
                                        {.longest = 8});
        CAPTURE(frame);
        CHECK(values_against(history.ao, [&](float a) {
                  return std::fabs(1 - double{a} - std::pow(7.0 / 8, frame)) < 1e-6;
              }) == "");
    }
}

TEST_CASE("temporal accumulation: the clamp holds a ghost within what the texels around show now") {
    const Scene scene = tilted_plane(0);
    const AoInputs inputs = inputs_of(scene, scene.camera);
    const auto after = [&](bool clamp) {
        AoHistory ghost = temporal_accumulation(Image<float>(kHistorySize, 0.0f), inputs, scene.camera, {},
                                                {.longest = 32});
        ghost.frames = Image<float>(kHistorySize, 31.0f);
        return temporal_accumulation(Image<float>(kHistorySize, 1.0f), inputs, scene.camera, ghost,
                                     {.longest = 32, .clamp = clamp})
            .ao;
    };
    CHECK(other_than(after(true), 1.0f) == "");
    CHECK(other_than(after(false), 1.0f / 32) == "");
    // A single texel that differs is in reach of its eight neighbours only.
    Image<float> spot(kHistorySize, 1.0f);
    spot.at(40, 30) = 0.5f;
    AoHistory dark =
        temporal_accumulation(Image<float>(kHistorySize, 0.0f), inputs, scene.camera, {}, {.longest = 2});
    const Image<float> ao =
        temporal_accumulation(spot, inputs, scene.camera, dark, {.longest = 2, .clamp = true}).ao;
    CHECK(pixels_against(kHistorySize, [&](int x, int y) {
              const bool beside = std::abs(x - 40) <= 1 && std::abs(y - 30) <= 1;
              const float history = beside ? 0.5f : 1.0f;
              return ao.at(x, y) == history + (spot.at(x, y) - history) / 2;
          }) == "");
}

TEST_CASE("temporal accumulation: the first frame, and a history of one frame, are the map itself") {
    const Scene scene = wall_on_floor(2);
    const AoInputs inputs = inputs_of(scene, scene.camera);
    const Image<float> first = noise_image(kHistorySize, 1), second = noise_image(kHistorySize, 2);
    const AoHistory before = temporal_accumulation(first, inputs, scene.camera, {}, {.longest = 8});
    CHECK(content_hash(before.ao) == content_hash(first));
    const AoHistory alone = temporal_accumulation(second, inputs, scene.camera, before, {.longest = 1});
    CHECK(content_hash(alone.ao) == content_hash(second));
}

TEST_CASE("temporal accumulation: methods without normals tell surfaces apart by depth") {
    const Scene scene = tilted_plane(0);
    AoInputs inputs = inputs_of(scene, scene.camera);
    inputs.normal = Image3(kHistorySize);
    for (int y = 0; y < kHistorySize.height; ++y) {
        for (int x = 0; x < kHistorySize.width; ++x) inputs.normal.set(x, y, glm::vec3(0));
    }
    const AoHistory before =
        temporal_accumulation(Image<float>(kHistorySize, 0.5f), inputs, scene.camera, {}, {.longest = 8});
    for (const float nearer : {1.005f, 1.02f}) {
        AoInputs moved = inputs;
        for (float& z : moved.view_depth.pixels) z /= nearer;
        const AoHistory after = temporal_accumulation(Image<float>(kHistorySize, 0.5f), moved, scene.camera,
                                                      before, {.longest = 8});
        CAPTURE(nearer);
        CHECK(after.frames.at(48, 32) == (nearer < 1.01f ? 2 : 1));
    }
}

TEST_CASE("temporal accumulation: the same bits in every form, no number lost at wild cameras") {
    const Scene scene = still_life();
    Camera now = scene.camera;
    now.eye += glm::dvec3(0.2, 0.1, -0.15);
    for (const Size size : {Size{61, 37}, Size{1, 1}, Size{8, 5}}) {
        const AoInputs before = inputs_of(scene, scene.camera, size), inputs = inputs_of(scene, now, size);
        const Image<float> first = noise_image(size, 1), second = noise_image(size, 2);
        for (const bool clamp : {false, true}) {
            const auto hashes = [&](const Run& run) {
                const TemporalSettings settings{.longest = 8, .clamp = clamp};
                const AoHistory last = temporal_accumulation(first, before, scene.camera, {}, settings, run);
                const AoHistory after = temporal_accumulation(second, inputs, now, last, settings, run);
                CHECK(outside_unit_interval(after.ao) == "");
                return content_hash(after.ao) + " " + content_hash(after.frames) + " " +
                       content_hash(after.normal);
            };
            const std::string plain = hashes(kOneLane);
            for_every_run({.threads = {1, 3}, .tile_sizes = {64}},
                          [&](const Run& run) { CHECK(hashes(run) == plain); });
        }
        for (const glm::dvec3 eye :
             {glm::dvec3(1e6, 0, 0), glm::dvec3(0, 0, 1e5), scene.camera.target + 0.01}) {
            Camera wild = scene.camera;
            wild.eye = eye;
            const AoHistory last = temporal_accumulation(first, before, wild, {}, {.longest = 8});
            const AoHistory after = temporal_accumulation(second, inputs, now, last, {.longest = 8});
            CHECK(outside_unit_interval(after.ao) == "");
        }
    }
}

TEST_CASE("temporal accumulation: settings out of range and maps of unlike sizes are usage errors") {
    for (const TemporalSettings& bad :
         {TemporalSettings{.longest = 0}, TemporalSettings{.longest = 4097}, TemporalSettings{.depth = -0.1f},
          TemporalSettings{.depth = std::nanf("")}, TemporalSettings{.normal = 1.5f}})
        CHECK_THROWS_AS(validate(bad), UsageError);
    const Scene scene = tilted_plane(0);
    const AoInputs large = inputs_of(scene, scene.camera), small = inputs_of(scene, scene.camera, {8, 8});
    const AoHistory history = temporal_accumulation(Image<float>({8, 8}, 1.0f), small, scene.camera, {}, {});
    CHECK_THROWS_AS(
        temporal_accumulation(Image<float>(kHistorySize, 1.0f), large, scene.camera, history, {.longest = 2}),
        UsageError);
}
