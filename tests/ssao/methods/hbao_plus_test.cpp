// HBAO+: open planes, and what each error of the listing does. Its formula: hbao_plus_formula_test.cpp
#include "ssao/methods/hbao_plus.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/inputs/pixel_fetch.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/listed_errors.h"
#include "tests/tools/plane_inputs.h"

using namespace crevice;

namespace {

// The mean over the 4 x 4 texels in the middle, all turns and shifts.
double centre_mean(const AoInputs& inputs, const HbaoPlusSettings& settings) {
    const Image<float> ao = hbao_plus(inputs, settings).ao;
    double sum = 0;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x)
            sum += static_cast<double>(ao.at(ao.size.width / 2 - 2 + x, ao.size.height / 2 - 2 + y));
    }
    return sum / 16;
}

std::string ao_hash(const PreparedStillLife& still, const HbaoPlusSettings& settings) {
    const AoInputs inputs = ao_inputs(still.g, still.scene.camera, pixel_fetch(settings));
    return content_hash(hbao_plus(inputs, settings).ao);
}

}  // namespace

TEST_CASE("hbao_plus: a plane at any tilt is open, with normals from either source") {
    const Size size{64, 48};
    for (const NormalSource normals : {NormalSource::gbuffer, NormalSource::depth}) {
        CAPTURE(static_cast<int>(normals));
        for (const float slope : {0.0f, 0.5f, 2.0f}) {
            const AoInputs inputs = tilted_inputs(size, slope, 0.25f);
            const Image<float> ao = hbao_plus(inputs, {.radius = 12, .normals = normals}).ao;
            CHECK(values_against(ao, [](float a) { return a > 0.999f; }) == "");
        }
        const Mesh floor =
            quad_mesh({glm::vec3(-40, -1, 60), {40, -1, 60}, {40, -1, 1}, {-40, -1, 1}}, {0, 1, 0});
        const Scene scene = scene_of({floor});
        const GBuffer g = normal_depth(scene, scene.camera, size);
        for (const float ao_scale : {0.5f, 1.0f}) {
            const HbaoPlusSettings settings{.ao_scale = ao_scale, .normals = normals};
            const AoInputs inputs = ao_inputs(g, scene.camera, pixel_fetch(settings));
            CHECK(buffer_statistics(hbao_plus(inputs, settings).ao).mean > 0.99);
        }
    }
}

TEST_CASE("hbao_plus: a step is as dark on any side of it, but not by the listing's table") {
    const auto darkness = [](StepSide side, RayTable table) {
        const AoInputs inputs = step_inputs({96, 96}, side, 4, 10);
        return 1 - centre_mean(inputs, {.samples = 8 * 16, .steps = 16, .radius = 30, .table = table});
    };
    const double right = darkness(StepSide::right, RayTable::even);
    CHECK(right > 0.2);
    for (const StepSide side : {StepSide::left, StepSide::below, StepSide::above})
        CHECK(std::fabs(darkness(side, RayTable::even) - right) < 0.02);
    // Five of eight directions go up, turned by less than 45 degrees to the left.
    CHECK(darkness(StepSide::above, RayTable::listed) > 1.5 * right);
    CHECK(darkness(StepSide::right, RayTable::listed) < 0.8 * right);
    CHECK(darkness(StepSide::below, RayTable::listed) < 0.8 * right);
}

TEST_CASE(
    "hbao_plus: an 8-bit texture has no negative cosines, so a quarter of all turns end at 90 degrees") {
    const AoInputs inputs = plain_inputs({96, 96}, 1000);
    int upright = 0, shorter = 0;
    for (int i = 0; i < 16; ++i) {
        const HbaoPlusSettings settings{.samples = 3, .steps = 1, .radius = 80, .turns = TurnFormat::unorm8};
        HbaoPlusSettings cured = settings;
        cured.turns = TurnFormat::float32;
        const int x = 48 + i % 4, y = 48 + i / 4;
        const auto first_ray = [&](const HbaoPlusSettings& s) {
            return explain_hbao_plus(inputs, s, x, y).samples[0].q_screen - glm::vec2(glm::ivec2(x, y)) -
                   0.5f;
        };
        const glm::vec2 stored = first_ray(settings), exact = first_ray(cured);
        upright += stored.x == 0 ? 1 : 0;
        shorter += glm::length(stored) < glm::length(exact) - 2 ? 1 : 0;
        if (exact.x > 3) CHECK(glm::length(stored - exact) < 2);
    }
    CHECK(upright >= 4);
    CHECK(upright <= 5);
    CHECK(shorter >= 1);
}

TEST_CASE(
    "hbao_plus: projected by the width, rays are longer by the aspect, in a square picture they are not") {
    for (const Size size : {Size{192, 96}, Size{96, 96}}) {
        CAPTURE(size.width);
        AoInputs inputs = plain_inputs(size, 1000);
        HbaoPlusSettings settings{.radius = 40};
        const auto longest = [&] {
            float length = 0;
            for (const ExplainedSample& sample :
                 explain_hbao_plus(inputs, settings, size.width / 2, size.height / 2).samples)
                length = std::max(length,
                                  glm::length(sample.q_screen - 0.5f * glm::vec2(size.width, size.height)));
            return static_cast<double>(length);
        };
        const double cured = longest(), reach = hbao_plus_reach_px(inputs, settings, 1000);
        settings.projected_by = ProjectedBy::width;
        const double aspect = static_cast<double>(size.width) / size.height;
        CHECK(std::fabs(longest() - aspect * cured) < 3);
        CHECK(std::fabs(hbao_plus_reach_px(inputs, settings, 1000) - 2 - aspect * (reach - 2)) < 1e-3);
    }
}

TEST_CASE(
    "hbao_plus: what is nearer than an eighth of the radius fades when squares are clamped, else nothing "
    "does") {
    // One ray of one step, a pixel long, meets a step of 1 unit beside the texel.
    const auto term = [](float radius, NearSamples near_samples) {
        const AoInputs inputs = step_inputs({96, 96}, StepSide::above, 0, 1);
        double most = 0;
        for (int i = 0; i < 4; ++i) {
            const HbaoPlusSettings settings{
                .samples = 64, .steps = 1, .radius = radius, .near_samples = near_samples};
            for (const ExplainedSample& s : explain_hbao_plus(inputs, settings, 48 + i, 48).samples)
                most = std::max(most, static_cast<double>(s.contribution));
        }
        return most;
    };
    const double exact = term(40, NearSamples::exact), clamped = term(40, NearSamples::clamped);
    CHECK(exact > 0.25);
    CHECK(clamped < 0.8 * exact);
    CHECK(std::fabs(term(4, NearSamples::exact) - term(4, NearSamples::clamped)) < 1e-6);
}

TEST_CASE("hbao_plus: normals from depth need no G-buffer, and are its normals on flat things") {
    const PreparedStillLife still(kTutorialMethods[0]);
    HbaoPlusSettings settings{.normals = NormalSource::depth};
    AoInputs inputs = ao_inputs(still.g, still.scene.camera, pixel_fetch(settings));
    const Image<float> from_depth = hbao_plus(inputs, settings).ao;
    settings.normals = NormalSource::gbuffer;
    const Image<float> from_buffer = hbao_plus(inputs, settings).ao;
    inputs.normal = Image3(inputs.size(), {0, 0, 0});
    settings.normals = NormalSource::depth;
    CHECK(content_hash(hbao_plus(inputs, settings).ao) == content_hash(from_depth));
    int surface = 0, alike = 0, other = 0;
    for (int y = 0; y < inputs.size().height; ++y) {
        for (int x = 0; x < inputs.size().width; ++x) {
            if (inputs.view_depth.at(x, y) == kInfinity) continue;
            const float off = std::fabs(from_depth.at(x, y) - from_buffer.at(x, y));
            ++surface;
            alike += off < 0.01f ? 1 : 0;
            other += off > 0.05f ? 1 : 0;
        }
    }
    CHECK(alike > 0.75 * surface);
    CHECK(other > 0);
}

TEST_CASE("hbao_plus: as_published is its four errors together, each of them changes the map") {
    const PreparedStillLife still(kTutorialMethods[0]);
    const HbaoPlusSettings cured;
    HbaoPlusSettings all = cured, published = cured;
    published.as_published = true;
    for (const NamedChange& error : kListedErrors) {
        CAPTURE(std::string(error.name));
        HbaoPlusSettings one = cured;
        error.change(one);
        error.change(all);
        CHECK(ao_hash(still, one) != ao_hash(still, cured));
    }
    CHECK(ao_hash(still, published) == ao_hash(still, all));
    CHECK(ao_hash(still, published) != ao_hash(still, cured));
}

TEST_CASE("hbao_plus: settings out of range are refused by name") {
    const auto refused = [](const HbaoPlusSettings& settings, const char* member) {
        CHECK_THROWS_WITH_AS(validate(settings), doctest::Contains(member), UsageError);
    };
    CHECK_NOTHROW(validate(HbaoPlusSettings{}));
    refused({.samples = 13}, "samples");
    refused({.samples = 2}, "samples");
    refused({.steps = 0}, "steps");
    refused({.radius = -1}, "radius");
    refused({.bias = 1}, "bias");
    refused({.exponent = 100}, "exponent");
    refused({.ao_scale = 0}, "ao_scale");
}
