// The Unity notes' blur: its weights, and what its look at the normals keeps apart.
#include "ssao/blur/normal_blur.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"

using namespace crevice;

namespace {

constexpr Size kSize = {37, 23};

double smooth_step_of(double low, double high, double a) {
    const double t = std::fmin(std::fmax((a - low) / (high - low), 0), 1);
    return t * t * (3 - 2 * t);
}

// The listing in double: one pass, (step, 0) or (0, step).
Image<double> plain_pass(const Image<double>& ao, const AoInputs& inputs, int step_x, int step_y,
                         double least) {
    const double weights[] = {.37004405286, .31718061674, .19823788546, .11453744493};
    Image<double> result(ao.size, 1.0);
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            if (inputs.view_depth.at(x, y) == kInfinity) continue;
            double sum = 0, total = 0;
            for (int k = -3; k <= 3; ++k) {
                const int tap_x = x + k * step_x, tap_y = y + k * step_y;
                if (tap_x < 0 || tap_y < 0 || tap_x >= ao.size.width || tap_y >= ao.size.height) continue;
                const double agreeing =
                    static_cast<double>(glm::dot(inputs.normal.at(x, y), inputs.normal.at(tap_x, tap_y)));
                const double w = weights[std::abs(k)] * (k == 0 ? 1 : smooth_step_of(least, 1, agreeing));
                sum += w * ao.at(tap_x, tap_y);
                total += w;
            }
            result.at(x, y) = sum / total;
        }
    }
    return result;
}

// Normals of every kind, some sky.
AoInputs unlike_inputs() {
    AoInputs inputs = plain_inputs(kSize, 5);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const glm::vec3 n(noise(1, x, y) - 0.5f, noise(2, x, y) - 0.5f, -1);
            inputs.normal.set(x, y, glm::normalize(n));
            if (noise(3, x, y) > 0.9f) {
                inputs.view_depth.at(x, y) = kInfinity;
                inputs.normal.set(x, y, {0, 0, 0});
            }
        }
    }
    return inputs;
}

}  // namespace

TEST_CASE("normal blur: the listing in double gives the same map") {
    const AoInputs inputs = unlike_inputs();
    const Image<float> noisy = noise_image(kSize, 5);
    for (const int step : {1, 3}) {
        for (const float least : {0.0f, 0.8f}) {
            const Image<float> blurred =
                normal_blur(noisy, inputs, {.iterations = 2, .step = step, .normal_threshold = least}).ao;
            Image<double> expected(kSize, 0.0);
            for (int y = 0; y < kSize.height; ++y) {
                for (int x = 0; x < kSize.width; ++x) expected.at(x, y) = static_cast<double>(noisy.at(x, y));
            }
            for (int i = 0; i < 2; ++i) {
                expected = plain_pass(expected, inputs, step, 0, static_cast<double>(least));
                expected = plain_pass(expected, inputs, 0, step, static_cast<double>(least));
            }
            CHECK(pixels_against(kSize, [&](int x, int y) {
                      return std::fabs(static_cast<double>(blurred.at(x, y)) - expected.at(x, y)) < 1e-5;
                  }) == "");
        }
    }
}

TEST_CASE("normal blur: open stays exactly open although the weights do not add up to 1") {
    float total = -kNormalBlurWeights[0];
    for (const float weight : kNormalBlurWeights) total += 2 * weight;
    CHECK(total == doctest::Approx(1.62995).epsilon(1e-4));
    CHECK(other_than(normal_blur(Image<float>(kSize, 1), unlike_inputs(), {.iterations = 3}).ao, 1) == "");
}

TEST_CASE("normal blur: stops where normals turn away, at any depth, and not where only depths differ") {
    AoInputs inputs = plain_inputs(kSize, 5);
    Image<float> ao(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < 18; ++x) ao.at(x, y) = 0.5f;
    }
    CHECK(normal_blur(ao, inputs, {}).ao.at(18, 11) < 0.9f);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < 18; ++x) inputs.view_depth.at(x, y) = 2;
    }
    CHECK(normal_blur(ao, inputs, {}).ao.at(18, 11) < 0.9f);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < 18; ++x) inputs.normal.set(x, y, {0.6f, 0, -0.8f});
    }
    CHECK(normal_blur(ao, inputs, {}).ao.at(18, 11) == 1);
    CHECK(normal_blur(ao, inputs, {.normal_threshold = 0.5f}).ao.at(18, 11) < 1);
    // From a threshold of 1 on nothing counts but the texel.
    CHECK(content_hash(normal_blur(ao, inputs, {.normal_threshold = 1}).ao) == content_hash(ao));
    CHECK(content_hash(normal_blur(ao, inputs, {.iterations = 0}).ao) == content_hash(ao));
}

TEST_CASE("normal blur: every run gives the same bits, and a map of one texel stays") {
    const AoInputs inputs = unlike_inputs();
    const Image<float> noisy = noise_image(kSize, 6);
    const std::string plain = content_hash(normal_blur(noisy, inputs, {.step = 2}, kOneLane).ao);
    for_every_run({.threads = {1, 3}}, [&](const Run& run) {
        CHECK(content_hash(normal_blur(noisy, inputs, {.step = 2}, run).ao) == plain);
    });
    CHECK(normal_blur(Image<float>({1, 1}, 0.25f), plain_inputs({1, 1}, 5), {.step = 8}).ao.at(0, 0) ==
          0.25f);
}

TEST_CASE("normal blur: settings out of their range are refused by name") {
    const auto refused = [](const char* member, NormalBlurSettings settings) {
        CHECK_THROWS_WITH_AS(validate(settings), doctest::Contains(member), UsageError);
        CHECK_THROWS_AS(normal_denoiser().validate(AnySettings::of(settings)), UsageError);
    };
    refused("blur_iterations", {.iterations = -1});
    refused("blur_iterations", {.iterations = 65});
    refused("blur_step", {.step = 0});
    refused("blur_step", {.step = 9});
    refused("blur_normal", {.normal_threshold = -0.1f});
    refused("blur_normal", {.normal_threshold = kNan});
}
