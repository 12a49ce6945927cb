// Alchemy's sum written anew in double, its traps, and what its switches change.
#include "ssao/methods/alchemy.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/inputs/pixel_fetch.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/flat_scenes.h"
#include "tests/tools/image_checks.h"

using namespace crevice;

namespace {

constexpr Size kSize = {96, 64};

AoInputs inputs_of(const Scene& scene, const AlchemySettings& settings) {
    return ao_inputs(normal_depth(scene, scene.camera, kSize), scene.camera, pixel_fetch(settings));
}

AlchemySettings full_size(AlchemyTaps taps = AlchemyTaps::disk) {
    AlchemySettings settings;
    settings.ao_scale = 1;
    settings.taps = taps;
    return settings;
}

constexpr AlchemyTaps kBoth[] = {AlchemyTaps::disk, AlchemyTaps::sphere};

// The paper's estimator over the surfaces that the taps of a texel found.
double by_the_paper(const Explanation& found, const AlchemySettings& s) {
    const double radius = s.radius, sigma = static_cast<double>(s.intensity) * radius,
                 epsilon = static_cast<double>(s.epsilon) * radius * radius;
    const glm::dvec3 p(found.p_view), n(found.n_view);
    double sum = 0;
    for (const ExplainedSample& sample : found.samples) {
        if (sample.verdict == std::string("too far away")) continue;
        const glm::dvec3 v = glm::dvec3(sample.r_view) - p;
        sum += std::fmax(0, glm::dot(v, n) - p.z * static_cast<double>(s.bias)) / (glm::dot(v, v) + epsilon);
    }
    return std::pow(std::fmax(0, 1 - 2 * sigma / s.samples * sum), static_cast<double>(s.exponent));
}

}  // namespace

TEST_CASE("alchemy: each texel is the paper's estimator over what its taps see") {
    for (const AlchemyTaps taps : kBoth) {
        AlchemySettings settings = full_size(taps);
        settings.exponent = 1.5f;
        const AoInputs inputs = inputs_of(still_life(), settings);
        const Image<float> ao = alchemy(inputs, settings).ao;
        int darker = 0;
        CHECK(pixels_against(kSize, [&](int x, int y) {
                  const Explanation found = explain_alchemy(inputs, settings, x, y);
                  if (!found.surface) return ao.at(x, y) == 1;
                  darker += ao.at(x, y) < 0.9f ? 1 : 0;
                  return std::fabs(by_the_paper(found, settings) - static_cast<double>(ao.at(x, y))) < 2e-5;
              }) == "");
        CHECK(darker > 200);
    }
}

TEST_CASE("alchemy: taps lie evenly in the disk, or below the half ball over p, and within the radius") {
    for (const AlchemyTaps taps : kBoth) {
        AlchemySettings settings = full_size(taps);
        settings.samples = 64;
        settings.radius = 12;
        // One scene unit a pixel, a sheet facing the eye.
        const AoInputs sheet = plain_inputs({65, 65}, 40);
        const Explanation found = explain_alchemy(sheet, settings, 32, 32);
        REQUIRE(found.samples.size() == 64);
        int inner_half = 0, above = 0;
        for (const ExplainedSample& sample : found.samples) {
            const glm::dvec3 offset(sample.offset);
            CHECK(std::hypot(offset.x, offset.y) <= 12 + 0.71);
            inner_half += std::hypot(offset.x, offset.y) < 12 / std::sqrt(2.0) ? 1 : 0;
            above += glm::dot(sample.offset, found.n_view) > 0 ? 1 : 0;
            if (taps == AlchemyTaps::sphere) CHECK(glm::length(offset) <= 12 * (1 + 1e-6));
        }
        if (taps == AlchemyTaps::disk) {
            CHECK(inner_half >= 28);  // half of the area
            CHECK(inner_half <= 36);
        } else {
            CHECK(above == 64);
            CHECK(inner_half > 40);  // a ball is seen denser in its middle
        }
    }
}

TEST_CASE(
    "alchemy: an open plane stays open at any slant, at both sizes; without bias it closes itself a little") {
    // At half size a texel's depth is the mean of four, which on a slanted plane is a little behind it.
    for (const AlchemyTaps taps : kBoth) {
        for (const float degrees : {0.0f, 30.0f, 60.0f, 75.0f}) {
            for (const float scale : {0.5f, 1.0f}) {
                AlchemySettings settings = full_size(taps);
                settings.ao_scale = scale;
                CAPTURE(degrees);
                CAPTURE(scale);
                const AoInputs inputs = inputs_of(tilted_plane(degrees), settings);
                CHECK(mean_inside(alchemy(inputs, settings).ao, inputs, 4) > (scale == 1 ? 0.9999 : 0.995));
            }
        }
    }
    AlchemySettings settings = full_size();
    settings.bias = 0;
    const AoInputs inputs = inputs_of(tilted_plane(60), settings);
    CHECK(other_than(alchemy(inputs, settings).ao, 1) != "");
}

TEST_CASE("alchemy: on a plane the closed form of a step, and darker the higher a wall is") {
    // A sheet at depth 40 whose left half lies `step` nearer, seen orthographically from far: over a texel
    // right beside the step every tap to its left finds v.n = step, v.v = d^2 + step^2, of which the mean over
    // the half disk is step log(1 + r^2 / (step^2 + epsilon)) / r^2.
    AlchemySettings settings = full_size();
    settings.samples = 64;
    settings.radius = 30;
    settings.intensity = 0.5f;
    settings.bias = 0;
    double before = 1;
    for (const float step : {2.0f, 4.0f, 8.0f}) {
        AoInputs sheet = plain_inputs({129, 129}, 40);
        for (int y = 0; y < 129; ++y) {
            for (int x = 0; x < 64; ++x) sheet.depth_map.at(x + 1, y + 1) = 40 - step;
        }
        double sum = 0;
        for (std::uint32_t seed = 1; seed <= 64; ++seed) {
            settings.seed = seed;
            sum += static_cast<double>(alchemy(sheet, settings).ao.at(64, 64));
        }
        const double h = step, r = 30, epsilon = static_cast<double>(settings.epsilon) * r * r;
        const double half_disk = h * std::log((r * r + h * h + epsilon) / (h * h + epsilon)) / (r * r) / 2;
        const double expected = 1 - 2 * 0.5 * r * half_disk;
        CAPTURE(step);
        CHECK(sum / 64 == doctest::Approx(expected).epsilon(0.02));
        CHECK(sum / 64 < before);
        before = sum / 64;
    }
}

TEST_CASE("alchemy: a wall that is higher leaves less of the floor in front of it open") {
    AlchemySettings settings = full_size();
    double before = 1.1;
    for (const float height : {0.0625f, 0.25f, 0.5f, 1.0f}) {
        const AoInputs inputs = inputs_of(wall_on_floor(height), settings);
        const double mean = mean_of_floor(alchemy(inputs, settings).ao, inputs, settings.radius);
        CAPTURE(height);
        CHECK(mean < before);
        before = mean;
    }
    CHECK(before < 0.8);
}

TEST_CASE("alchemy: intensity and bias act as the formula has them; the background takes nothing") {
    AlchemySettings settings = full_size();
    const Scene scene = still_life();
    const AoInputs inputs = inputs_of(scene, settings);
    const double plain = mean_inside(alchemy(inputs, settings).ao, inputs);
    AlchemySettings other = settings;
    other.intensity = 0.25f;
    CHECK(mean_inside(alchemy(inputs, other).ao, inputs) > plain);
    other.intensity = 0;
    CHECK(other_than(alchemy(inputs, other).ao, 1) == "");
    other = settings;
    other.bias = 1;  // as deep as the scene
    CHECK(other_than(alchemy(inputs, other).ao, 1) == "");
    // A floor to the horizon under the sky: what the taps see of the sky lies over the floor's plane.
    const AoInputs floor = inputs_of(tilted_plane(80), settings);
    int sky = 0;
    for (int x = 0; x < kSize.width; ++x) {
        for (const ExplainedSample& sample : explain_alchemy(floor, settings, x, 20).samples) {
            if (sample.r_view.z < 1000) continue;
            ++sky;
            CHECK(sample.contribution == 0);
        }
    }
    settings.radius = 30;
    for (const ExplainedSample& sample : explain_alchemy(floor, settings, 48, 32).samples)
        sky += sample.r_view.z > 1000 && sample.contribution == 0 ? 1 : 0;
    CHECK(sky > 0);
}

TEST_CASE("alchemy: points of the ball in front of the near plane are left out") {
    AlchemySettings settings = full_size(AlchemyTaps::sphere);
    settings.samples = 64;
    settings.radius = 12;
    AoInputs sheet = plain_inputs({65, 65}, 40);
    sheet.near_plane = 35;
    for (int x = 0; x < 60; ++x) sheet.depth_map.at(x + 1, 33) = 36;
    int in_front = 0, taking = 0;
    for (const ExplainedSample& sample : explain_alchemy(sheet, settings, 32, 32).samples) {
        if (sample.q_view.z <= 35) {
            ++in_front;
            CHECK(sample.contribution == 0);
        }
        taking += sample.contribution > 0 ? 1 : 0;
    }
    CHECK(in_front > 5);
    CHECK(taking > 0);
}

TEST_CASE("alchemy: the seed changes the map; settings out of range are refused by name") {
    AlchemySettings settings = full_size();
    const AoInputs inputs = inputs_of(still_life(), settings);
    AlchemySettings seeded = settings;
    seeded.seed = 2;
    CHECK(content_hash(alchemy(inputs, settings).ao) != content_hash(alchemy(inputs, seeded).ao));
    const auto refused = [](auto change, const char* name) {
        AlchemySettings wrong;
        change(wrong);
        CHECK_THROWS_WITH_AS(validate(wrong), doctest::Contains(name), UsageError);
    };
    refused([](auto& s) { s.samples = 0; }, "samples");
    refused([](auto& s) { s.samples = 65; }, "samples");
    refused([](auto& s) { s.radius = -1; }, "radius");
    refused([](auto& s) { s.radius = kInfinity; }, "radius");
    refused([](auto& s) { s.intensity = -1; }, "intensity");
    refused([](auto& s) { s.bias = 2; }, "bias");
    refused([](auto& s) { s.epsilon = 0; }, "epsilon");
    refused([](auto& s) { s.exponent = kNan; }, "exponent");
    refused([](auto& s) { s.ao_scale = 0.25f; }, "ao_scale");
}
