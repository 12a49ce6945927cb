// The published shader's sum written anew in double, its traps, and what its switches change.
#include "ssao/methods/sao.h"

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

AoInputs inputs_of(const Scene& scene, const SaoSettings& settings, Size size = kSize) {
    return ao_inputs(normal_depth(scene, scene.camera, size), scene.camera, pixel_fetch(settings));
}

SaoSettings full_size() {
    SaoSettings settings;
    settings.ao_scale = 1;
    return settings;
}

// The published shader, its lengths as it has them: the sum over the surfaces that the taps of a texel found.
double by_the_shader(const Explanation& found, const SaoSettings& s, float near_plane) {
    const double r = s.radius, bias = static_cast<double>(s.bias) * r,
                 epsilon = static_cast<double>(s.epsilon) * r * r,
                 intensity = static_cast<double>(s.intensity) * r;
    const glm::dvec3 p(found.p_view), n(found.n_view);
    double sum = 0;
    for (const ExplainedSample& sample : found.samples) {
        const glm::dvec3 v = glm::dvec3(sample.r_view) - p;
        const double vv = glm::dot(v, v), f = std::fmax(r * r - vv, 0);
        if (sample.r_view.z > near_plane)
            sum += f * f * f * std::fmax((glm::dot(v, n) - bias) / (epsilon + vv), 0);
    }
    return std::pow(std::fmax(0, 1 - sum * intensity * 5 / (s.samples * std::pow(r, 6))),
                    static_cast<double>(s.exponent));
}

}  // namespace

TEST_CASE("sao: each texel is the published shader's formula over what its taps see") {
    for (const float radius : {0.5f, 1.0f, 7.0f}) {
        SaoSettings settings = full_size();
        settings.radius = radius;
        settings.exponent = 1.5f;
        const AoInputs inputs = inputs_of(still_life(), settings);
        const Image<float> ao = sao(inputs, settings).ao;
        int darker = 0;
        CAPTURE(radius);
        CHECK(pixels_against(kSize, [&](int x, int y) {
                  if ((x + 3 * y) % 7 != 0) return true;  // each explanation makes a pyramid of its own
                  const Explanation found = explain_sao(inputs, settings, x, y);
                  if (!found.surface) return ao.at(x, y) == 1;
                  darker += ao.at(x, y) < 0.9f ? 1 : 0;
                  return std::fabs(by_the_shader(found, settings, 0.5f) - static_cast<double>(ao.at(x, y))) <
                         2e-5;
              }) == "");
        CHECK(darker > 20);
    }
}

TEST_CASE("sao: taps follow the spiral, outer ones from cells an eighth of their distance wide") {
    SaoSettings settings = full_size();
    settings.samples = 9;
    settings.radius = 60;
    // One scene unit a pixel.
    const AoInputs sheet = plain_inputs({257, 257}, 40);
    const auto distances_off = [&](const SaoSettings& s) {
        const Explanation found = explain_sao(sheet, s, 128, 128);
        REQUIRE(found.samples.size() == 9);
        double first_angle = 0, furthest = 0;
        for (int i = 0; i < 9; ++i) {
            const glm::dvec2 offset = glm::dvec2(found.samples[static_cast<std::size_t>(i)].q_screen) - 128.5;
            const double part = (i + 0.5) / 9;
            // Turned as the outermost tap but the last of the picture itself is.
            if (i == 1) first_angle = std::atan2(offset.y, offset.x) - 2 * kPi * 7 * part;
            if (i < 1) continue;
            const double angle = first_angle + 2 * kPi * 7 * part;
            const glm::dvec2 expected = 60 * part * glm::dvec2(std::cos(angle), std::sin(angle));
            furthest = std::fmax(furthest, glm::length(offset - expected) / (60 * part));
        }
        return furthest;
    };
    // The first angle itself is off by up to sqrt(1/2) pixel in ten.
    const double of_pyramid = distances_off(settings);
    settings.levels = 0;
    const double of_picture = distances_off(settings);
    CHECK(of_picture < 0.15);
    CHECK(of_pyramid < 0.15 + 0.125 * std::sqrt(2.0));
    CHECK(of_pyramid > of_picture);
}

TEST_CASE(
    "sao: an open plane is exactly open at any slant; with depths where the tap fell it closes itself") {
    for (const float degrees : {0.0f, 30.0f, 60.0f, 75.0f}) {
        for (const float scale : {0.5f, 1.0f}) {
            SaoSettings settings;
            settings.ao_scale = scale;
            CAPTURE(degrees);
            CAPTURE(scale);
            // Wide enough that the taps reach the second level and more.
            const Size size{384, 256};
            const AoInputs inputs = inputs_of(tilted_plane(degrees), settings, size);
            CHECK(other_than(sao(inputs, settings).ao, 1) == "");
            settings.place = SaoPlace::tapped;
            const double tapped = mean_inside(sao(inputs, settings).ao, inputs, 4);
            if (degrees == 60) CHECK(tapped < 0.998);
            settings.place = SaoPlace::picked;
            settings.as_published = true;
            if (degrees == 60) CHECK(mean_inside(sao(inputs, settings).ao, inputs, 4) < 0.998);
            settings.levels = 0;
            CHECK(other_than(sao(inputs, settings).ao, 1) == "");
        }
    }
}

TEST_CASE("sao: the closed form of a step") {
    // A sheet at depth 40 whose left half lies h nearer, seen orthographically, beside the step: taps lie
    // evenly in distance d, half of them on the nearer sheet, where v.v = d^2 + h^2 and v.n = h.
    SaoSettings settings = full_size();
    settings.samples = 64;
    settings.turns = 7;
    settings.radius = 32;
    settings.levels = 0;
    settings.intensity = 0.25f;
    for (const float step : {2.0f, 8.0f, 16.0f}) {
        AoInputs sheet = plain_inputs({129, 129}, 40);
        for (int y = 0; y < 129; ++y) {
            for (int x = 0; x < 64; ++x) sheet.depth_map.at(x + 1, y + 1) = 40 - step;
        }
        double sum = 0;
        constexpr std::uint32_t kSeeds = 96;
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            settings.seed = seed;
            sum += static_cast<double>(sao(sheet, settings).ao.at(64, 64));
        }
        constexpr int kParts = 4096;
        const double h = static_cast<double>(step) / 32;
        double integral = 0;
        for (int i = 0; i < kParts; ++i) {
            const double d = (i + 0.5) / kParts, vv = d * d + h * h, f = std::fmax(0, 1 - vv);
            // Half of the circle but for the texel's own half pixel.
            const double share = d > 0.5 / 32 ? std::acos(0.5 / 32 / d) / kPi : 0;
            integral += share * f * f * f * std::fmax(0, h - 0.01) / (0.01 + vv) / kParts;
        }
        CAPTURE(step);
        CHECK(sum / kSeeds == doctest::Approx(1 - 5 * 0.25 * integral).epsilon(0.01));
    }
}

TEST_CASE("sao: a wall that is higher leaves less of the floor in front of it open") {
    SaoSettings settings = full_size();
    double before = 1.1;
    for (const float height : {0.0625f, 0.25f, 0.5f, 1.0f}) {
        const AoInputs inputs = inputs_of(wall_on_floor(height), settings);
        const double mean = mean_of_floor(sao(inputs, settings).ao, inputs, settings.radius);
        CAPTURE(height);
        CHECK(mean < before);
        before = mean;
    }
    CHECK(before < 0.9);
}

TEST_CASE("sao: what is further than the radius takes nothing, however far in front") {
    SaoSettings settings = full_size();
    settings.radius = 20;
    for (const float step : {19.0f, 21.0f}) {
        AoInputs sheet = plain_inputs({129, 129}, 40);
        for (int y = 0; y < 129; ++y) {
            for (int x = 0; x < 129; ++x) {
                if (x != 64 || y != 64) sheet.depth_map.at(x + 1, y + 1) = 40 - step;
            }
        }
        CHECK((sao(sheet, settings).ao.at(64, 64) == 1) == (step > 20));
    }
}

TEST_CASE("sao: the pyramid changes the map only where taps are far; the published turns repeat") {
    SaoSettings settings = full_size();
    const AoInputs inputs = inputs_of(still_life(), settings, {384, 256});
    const Image<float> plain = sao(inputs, settings).ao;
    SaoSettings other = settings;
    other.levels = 0;
    const Image<float> from_picture = sao(inputs, other).ao;
    CHECK(content_hash(plain) != content_hash(from_picture));
    CHECK(mean_inside(plain, inputs) == doctest::Approx(mean_inside(from_picture, inputs)).epsilon(0.005));
    settings.radius = other.radius = 0.05f;  // below 16 pixels everywhere
    CHECK(content_hash(sao(inputs, settings).ao) == content_hash(sao(inputs, other).ao));
    settings.radius = other.radius = 1;
    // A seed turns the spirals, but not the published ones.
    other = settings;
    other.seed = 2;
    CHECK(content_hash(sao(inputs, other).ao) != content_hash(plain));
    settings.as_published = other.as_published = true;
    CHECK(content_hash(sao(inputs, other).ao) == content_hash(sao(inputs, settings).ao));
    other.turns = 6;
    CHECK(content_hash(sao(inputs, other).ao) != content_hash(sao(inputs, settings).ao));
}

TEST_CASE("sao: the published turn of a texel is 10 (3x xor y + xy)") {
    SaoSettings settings = full_size();
    settings.as_published = true;
    settings.samples = 1;
    settings.turns = 2;  // one tap half the radius away, turned by 2 pi
    settings.radius = 14;
    const AoInputs sheet = plain_inputs({128, 128}, 40);
    for (const auto& [x, y] : {std::pair{30, 40}, {31, 40}, {63, 17}, {50, 50}}) {
        const glm::dvec2 at(explain_sao(sheet, settings, x, y).samples.at(0).q_screen);
        const double angle = 10.0 * ((3 * x) ^ (y + x * y));
        CHECK(std::fabs(at.x - (x + 0.5 + 7 * std::cos(angle))) <= 0.51);
        CHECK(std::fabs(at.y - (y + 0.5 + 7 * std::sin(angle))) <= 0.51);
    }
}

TEST_CASE("sao: settings out of range are refused by name") {
    const auto refused = [](auto change, const char* name) {
        SaoSettings wrong;
        change(wrong);
        CHECK_THROWS_WITH_AS(validate(wrong), doctest::Contains(name), UsageError);
    };
    refused([](auto& s) { s.samples = 0; }, "samples");
    refused([](auto& s) { s.samples = 65; }, "samples");
    refused([](auto& s) { s.turns = 0; }, "turns");
    refused([](auto& s) { s.radius = kNan; }, "radius");
    refused([](auto& s) { s.intensity = -1; }, "intensity");
    refused([](auto& s) { s.bias = -1; }, "bias");
    refused([](auto& s) { s.epsilon = 0; }, "epsilon");
    refused([](auto& s) { s.levels = 6; }, "levels");
    refused([](auto& s) { s.exponent = 65; }, "exponent");
    refused([](auto& s) { s.ao_scale = 2; }, "ao_scale");
}
