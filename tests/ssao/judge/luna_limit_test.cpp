#include "ssao/judge/luna_limit.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "ssao/rays/ray_cast_ao.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize{64, 36};

AoInputs inputs_of(const Scene& scene, const TutorialMethod& method, float scale) {
    LunaSettings settings = method.settings;
    settings.ao_scale = scale;
    return ao_inputs(normal_depth(scene, scene.camera, kSize), scene.camera, method.fetch(settings));
}

}  // namespace

TEST_CASE("limit: the mean of the method over other seeds tends to it, within the stated error") {
    const Scene scene = still_life();
    for (const TutorialMethod& method : kTutorialMethods) {
        CAPTURE(method.name);
        const AoInputs inputs = inputs_of(scene, method, 1);
        LunaSettings settings = method.settings;
        settings.exponent = 1;
        settings.samples = 3;  // few: their mean has the same limit as that of many
        const ReferenceImage limit = luna_limit(inputs, settings, 64);
        const int seeds = 64;
        std::vector<double> sum(limit.mean.pixels.size()), squares(sum.size());
        for (int i = 0; i < seeds; ++i) {
            settings.seed = 100 + static_cast<std::uint32_t>(i);
            const Image<float> ao = luna_occlusion(inputs, settings, {}).ao;
            for (std::size_t k = 0; k < sum.size(); ++k) {
                sum[k] += static_cast<double>(ao.pixels[k]);
                squares[k] += static_cast<double>(ao.pixels[k]) * static_cast<double>(ao.pixels[k]);
            }
        }
        double distance = 0, expected = 0, difference = 0;
        int noisy = 0;
        for (std::size_t k = 0; k < sum.size(); ++k) {
            const double mean = sum[k] / seeds, variance = (squares[k] / seeds - mean * mean) / (seeds - 1);
            const double error = static_cast<double>(limit.error.pixels[k]);
            const double off = mean - static_cast<double>(limit.mean.pixels[k]);
            if (variance + error * error < 1e-12) {
                CHECK(std::abs(off) < 1e-5);
                continue;
            }
            distance += off * off;
            expected += variance + error * error;
            difference += off;
            ++noisy;
        }
        REQUIRE(noisy > 200);
        // A sum of so many squares scatters by a few percent of itself.
        CHECK(distance / expected == doctest::Approx(1).epsilon(0.3));
        CHECK(std::abs(difference / noisy) < 5 * std::sqrt(expected) / noisy);
    }
}

TEST_CASE("limit: halves are independent means whose mean is the limit; the exponent comes last") {
    const Scene scene = still_life();
    const TutorialMethod& method = kTutorialMethods[0];
    const AoInputs inputs = inputs_of(scene, method, 0.5f);
    LunaSettings linear = method.settings;
    linear.exponent = 1;
    const ReferenceImage before = luna_limit(inputs, linear, 16),
                         after = luna_limit(inputs, method.settings, 16);
    CHECK(after.mean.size == inputs.size());
    int different = 0;
    for (int y = 0; y < inputs.size().height; ++y) {
        for (int x = 0; x < inputs.size().width; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            const float a = before.half[0].at(x, y), b = before.half[1].at(x, y), mean = before.mean.at(x, y);
            CHECK(std::abs((a + b) / 2 - mean) < 1e-6f);
            different += a != b ? 1 : 0;
            CHECK(std::abs(after.mean.at(x, y) - std::pow(mean, method.settings.exponent)) < 2e-6f);
            if (inputs.view_depth.at(x, y) == kInfinity) {
                CHECK(mean == 1);
                CHECK(before.error.at(x, y) == 0);
            }
        }
    }
    CHECK(different > 100);
}

TEST_CASE("limit: too few seeds are refused") {
    const Scene scene = still_life();
    const AoInputs inputs = inputs_of(scene, kTutorialMethods[0], 1);
    for (const int seeds : {-1, 0, kReplicates - 1, (1 << 20) + 1})
        CHECK_THROWS_AS(luna_limit(inputs, kXjunSettings, seeds), UsageError);
}
