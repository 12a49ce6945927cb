// The weights for maps whose noise repeats every eight texels.
#include <cmath>

#include <doctest/doctest.h>

#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/rays/ray_cast_map.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"

using namespace crevice;

TEST_CASE(
    "interleaved weights: of a pattern of 8x8 texels one blur leaves its mean, where Luna's weights leave "
    "the pattern") {
    constexpr Size kSize = {64, 40};
    const Image<float> square = noise_image({kPatternSide, kPatternSide}, 3);
    Image<float> ao(kSize);
    double mean = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) ao.at(x, y) = square.at(x % kPatternSide, y % kPatternSide);
    }
    for (int y = 0; y < kPatternSide; ++y) {
        for (int x = 0; x < kPatternSide; ++x)
            mean += static_cast<double>(square.at(x, y)) / (kPatternSide * kPatternSide);
    }
    const auto furthest_from_mean = [&](const BlurWeights& weights) {
        const Image<float> blurred =
            bilateral_blur(ao, plain_inputs(kSize, 5), {.weights = weights, .iterations = 1}).ao;
        double furthest = 0;
        for (int y = kBlurRadius; y < kSize.height - kBlurRadius; ++y) {
            for (int x = kBlurRadius; x < kSize.width - kBlurRadius; ++x)
                furthest = std::max(furthest, std::fabs(static_cast<double>(blurred.at(x, y)) - mean));
        }
        return furthest;
    };
    CHECK(furthest_from_mean(kInterleavedBlurWeights) < 1e-6);
    CHECK(furthest_from_mean(kLunaBlurWeights) > 0.005);
}
