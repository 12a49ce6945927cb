// The forms of GTAO, its step and falloff parameters, and samples from levels of the depth pyramid.
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/gtao.h"
#include "ssao/methods/slices.h"
#include "tests/tools/every_run.h"
#include "tests/tools/flat_scenes.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/plane_inputs.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr GtaoForm kForms[] = {GtaoForm::losses, GtaoForm::paper, GtaoForm::xegtao};
constexpr Size kSize{53, 31};

AoInputs inputs_of(const Scene& scene, Size size, const GtaoSettings& settings) {
    return ao_inputs(normal_depth(scene, scene.camera, size), scene.camera, pixel_fetch(settings));
}

Image<float> map_of(const Scene& scene, const GtaoSettings& settings, Size size = kSize) {
    return gtao(inputs_of(scene, size, settings), settings).ao;
}

double mean_of(const Image<float>& ao) {
    return mean_where(ao, 0, [](int, int) { return true; });
}

// An orthographic view of a plane without end: one answer, but for the noise of its slices.
constexpr Size kPlane{40, 40};
constexpr float kSlope = 0.7f;
double mean_on_plane(const GtaoSettings& settings) {
    const Image<float> ao = gtao(tilted_inputs(kPlane, kSlope), settings).ao;
    return mean_where(ao, 12, [](int, int) { return true; });
}

// What an open plane keeps, a part of the slices' lengths taken nearer to 1.
double kept_by_open_plane(double slope, double share_of_one) {
    const double tilt = std::atan(slope);
    double sum = 0;
    constexpr int kSlices = 2000;
    for (int i = 0; i < kSlices; ++i) {
        const double n_t = std::sin(tilt) * std::cos(kPi * (i + 0.5) / kSlices), n_v = std::cos(tilt);
        const double length = std::hypot(n_t, n_v), gamma = std::atan2(n_t, n_v);
        sum += ((1 - share_of_one) * length + share_of_one) * (std::cos(gamma) + gamma * std::sin(gamma));
    }
    return sum / kSlices;
}

}  // namespace

TEST_CASE("gtao forms: what an open plane keeps; with few slices the surplus of some is cut off") {
    GtaoSettings settings{.samples = 192, .radius = 5, .ao_scale = 1};
    CHECK(mean_on_plane(settings) == doctest::Approx(1).epsilon(1e-4));
    settings.form = GtaoForm::paper;
    CHECK(mean_on_plane(settings) == doctest::Approx(kept_by_open_plane(kSlope, 0)).epsilon(2e-3));
    settings.samples = 4;
    CHECK(mean_on_plane(settings) < 0.99);
    // A texel in numbers, before the cut: a single slice is worth length * (cos gamma + gamma sin gamma).
    const AoInputs plane = tilted_inputs(kPlane, kSlope);
    double least = 1, most = 1;
    for (int x = 14; x < 26; ++x) {
        float sum = 0;
        for (const ExplainedSample& sample : explain_gtao(plane, settings, x, 20).samples)
            sum += sample.contribution;
        least = std::fmin(least, 1 - double{sum});
        most = std::fmax(most, 1 - double{sum});
    }
    const double tilt = std::atan(double{kSlope});
    CHECK(most <= std::cos(tilt) + tilt * std::sin(tilt) + 1e-4);
    CHECK(most > 1.02);
    CHECK(least >= std::cos(tilt) - 1e-4);  // across the slope, where the slice is short
    CHECK(least < 0.95);
}

TEST_CASE("gtao forms: XeGTAO's takes short slices for longer, and is brighter where the radius is small") {
    GtaoSettings settings{.samples = 192, .radius = 30, .form = GtaoForm::xegtao, .ao_scale = 1};
    settings.exponent = 0.5f;  // what is above 1 would be cut
    const double kept = kept_by_open_plane(kSlope, 0.05);
    CHECK(kept > 1);
    CHECK(mean_on_plane(settings) == 1);
    const AoInputs plane = tilted_inputs(kPlane, kSlope);
    const auto explained_sum = [&](float radius) {
        settings.radius = radius;
        float sum = 0;
        for (const ExplainedSample& sample : explain_gtao(plane, settings, 20, 20).samples)
            sum += sample.contribution;
        return double{sum} / 32;
    };
    CHECK(1 - explained_sum(30) == doctest::Approx(kept).epsilon(2e-3));
    // A radius of 0 pixels gives 5 % back; XeGTAO divides that by the number of slices, too.
    CHECK(explained_sum(30) - explained_sum(1e-6f) == doctest::Approx(0.05 / 32).epsilon(0.01));
}

TEST_CASE("gtao forms: in a box all agree but for their noise") {
    const Scene scene = cornell_scene();
    GtaoSettings settings{.samples = 192, .radius = scene.length_unit, .ao_scale = 1};
    const double losses = mean_of(map_of(scene, settings));
    CHECK(losses < 0.98);
    settings.form = GtaoForm::paper;
    CHECK(std::fabs(mean_of(map_of(scene, settings)) - losses) < 0.01);
    settings.form = GtaoForm::xegtao;
    CHECK(std::fabs(mean_of(map_of(scene, settings)) - losses) < 0.01);
}

TEST_CASE("gtao forms: the paper's thickness, too, lets things behind an edge occlude less") {
    const Scene scene = cornell_scene();
    GtaoSettings settings{.samples = 54, .radius = 2, .form = GtaoForm::paper};
    const double solid = mean_of(map_of(scene, settings));
    settings.thickness = 0.5f;
    CHECK(mean_of(map_of(scene, settings)) > solid + 1e-3);
}

TEST_CASE("gtao: a radius and its multiplier are one length; without falloff all nearer than it counts") {
    const Scene scene = still_life();
    const GtaoSettings one{.radius = 1, .radius_multiplier = 1}, two{.radius = 0.5f, .radius_multiplier = 2};
    CHECK(content_hash(map_of(scene, one)) == content_hash(map_of(scene, two)));
    CHECK(gtao_reach_px(inputs_of(scene, kSize, one), one, 3) ==
          gtao_reach_px(inputs_of(scene, kSize, two), two, 3));
    double before = 1;
    for (const float falloff : {1.0f, 0.615f, 0.3f, 0.0f}) {
        GtaoSettings settings = one;
        settings.falloff = falloff;
        const double mean = mean_of(map_of(scene, settings));
        CAPTURE(falloff);
        CHECK(mean < before);
        before = mean;
    }
}

TEST_CASE("gtao: a step's distance is a shifted part of the radius to a power, and a pixel and a third") {
    const SlicePlan plan = slice_plan(18);
    for (const float step_power : {1.0f, 1.5f, 2.0f, 3.0f}) {
        for (int step = 0; step < plan.steps; ++step) {
            for (const float noise : {0.0f, 0.4f, 0.99f}) {
                const double shifted = double{noise} + (2 + step * 3) * 0.6180339887498948482;
                const double part = (step + shifted - std::floor(shifted)) / 3;
                CAPTURE(step_power);
                CAPTURE(step);
                CHECK(double{step_distance_px(2, step, plan, noise, 80.0f, step_power)} ==
                      doctest::Approx(std::pow(part, double{step_power}) * 80 + 1.3).epsilon(1e-5));
            }
        }
    }
    GtaoSettings dense{.samples = 54, .radius = 1}, even = dense;
    even.step_power = 1;
    CHECK(content_hash(map_of(still_life(), dense)) != content_hash(map_of(still_life(), even)));
}

TEST_CASE("gtao levels: distant samples are pixels of the picture; planes stay open, corners as dark") {
    GtaoSettings settings{.samples = 54, .radius = 3, .ao_scale = 1};
    const Size size{160, 90};
    for (const float level_offset : {2.0f, 3.3f}) {
        settings.level_offset = level_offset;
        CAPTURE(level_offset);
        for (const float degrees : {0.0f, 40.0f, 75.0f})
            CHECK(mean_of(map_of(tilted_plane(degrees), settings, {96, 64})) > 0.999);
        const AoInputs inputs = inputs_of(still_life(), size, settings);
        int coarse = 0;
        for (int x = 3; x < size.width; x += 13) {
            const Explanation explained = explain_gtao(inputs, settings, x, 60);
            for (const ExplainedSample& sample : explained.samples) {
                if (sample.weight == 0) continue;
                const FetchedPixel<float> pixel =
                    fetch_pixel<float>(inputs, {sample.q_screen.x, sample.q_screen.y});
                CHECK(pixel.at.x == sample.q_screen.x);
                CHECK(pixel.r.z == sample.q_view.z);
                const float away =
                    std::hypot(sample.q_screen.x - (static_cast<float>(x) + 0.5f), sample.q_screen.y - 60.5f);
                coarse += away > 14 ? 1 : 0;
            }
        }
        CHECK(coarse > 20);
    }
    const auto mean_at = [&](float level_offset) {
        settings.level_offset = level_offset;
        return mean_of(map_of(still_life(), settings, size));
    };
    CHECK(std::fabs(mean_at(3.3f) - mean_at(30)) < 0.003);
    CHECK(mean_at(3.3f) != mean_at(30));
}

TEST_CASE("gtao levels: what lies beyond the reach changes nothing, although cells are wide") {
    const Size size{161, 61};
    for (const float level_offset : {2.0f, 3.3f, 30.0f}) {
        const GtaoSettings settings{.radius = 20, .level_offset = level_offset, .ao_scale = 1};
        AoInputs inputs = plain_inputs(size, 1000);
        const Image<float> before = gtao(inputs, settings).ao;
        constexpr int kColumns = 30;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < kColumns; ++x) inputs.depth_map.at(x + 1, y + 1) = 980;
        }
        const Image<float> after = gtao(inputs, settings).ao;
        const double reach_px = gtao_reach_px(inputs, settings, 1000);
        int changed = 0;
        CAPTURE(level_offset);
        CHECK(pixels_against(size, [&](int x, int y) {
                  const bool same = before.at(x, y) == after.at(x, y);
                  changed += same ? 0 : 1;
                  return same || x - kColumns <= reach_px;
              }) == "");
        CHECK(changed > 1000);
    }
}

TEST_CASE("gtao forms: the same bits for every run and power of two; in [0,1]; explained to the bit") {
    for (const GtaoForm form : kForms) {
        for (const float scale : {0.5f, 1.0f}) {
            GtaoSettings settings{.radius = 1, .form = form, .step_power = 1.5f, .thickness = 0.3f};
            settings.level_offset = 2;
            settings.ao_scale = scale;
            CAPTURE(static_cast<int>(form));
            CAPTURE(scale);
            constexpr Size size{61, 33};
            const AoInputs inputs = inputs_of(still_life(), size, settings);
            const Image<float> ao = gtao(inputs, settings, kOneLane).ao;
            CHECK(outside_unit_interval(ao) == "");
            for_every_run({.threads = {1, 3}}, [&](const Run& run) {
                CHECK(content_hash(gtao(inputs, settings, run).ao) == content_hash(ao));
            });
            CHECK(pixels_against(ao.size, [&](int x, int y) {
                      if ((x + y) % 7 != 0) return true;
                      const Explanation explained = explain_gtao(inputs, settings, x, y);
                      float sum = 0;
                      for (const ExplainedSample& sample : explained.samples) sum = sum + sample.contribution;
                      return explained.value_of_sum(sum) == ao.at(x, y);
                  }) == "");
            GtaoSettings larger = settings;
            larger.radius *= 8;
            CHECK(content_hash(map_of(scaled(still_life(), 3), larger, size)) == content_hash(ao));
        }
    }
}

TEST_CASE("gtao forms: settings out of range are refused by name") {
    const auto refused = [](auto change, const char* name) {
        GtaoSettings settings;
        change(settings);
        CHECK_THROWS_WITH_AS(validate(settings), doctest::Contains(name), UsageError);
    };
    refused([](auto& s) { s.radius_multiplier = 0.2f; }, "radius_multiplier: ");
    refused([](auto& s) { s.falloff = 1.1f; }, "falloff: ");
    refused([](auto& s) { s.step_power = 0.5f; }, "step_power: ");
    refused([](auto& s) { s.level_offset = NAN; }, "level_offset: ");
}
