// The paper's blur written anew in double, and its traps.
#include "ssao/blur/sao_blur.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/blur/bilateral_blur.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"

using namespace crevice;

namespace {

constexpr Size kSize = {45, 37};

// Depths in steps of .05 from 3 to 3.35, a fifth of the texels sky.
AoInputs uneven_inputs() {
    AoInputs inputs = plain_inputs(kSize, 3);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            inputs.view_depth.at(x, y) =
                noise(5, x, y) < 0.2f ? kInfinity : 3 + 0.05f * std::floor(8 * noise(6, x / 3, y / 3));
        }
    }
    return inputs;
}

// One direction, as the published shader's loop has it, but for the key in metres and no addition to the total.
double along(const std::vector<double>& ao, const Image<float>& depth, double limit, int x, int y, int dx,
             int dy) {
    constexpr double kGaussian[] = {0.153170, 0.144893, 0.122649, 0.092902, 0.062970};
    const auto value = [&](int i, int j) { return ao[static_cast<std::size_t>(j * kSize.width + i)]; };
    double total = kGaussian[0], sum = value(x, y) * total;
    for (int r = -4; r <= 4; ++r) {
        const int i = x + 2 * r * dx, j = y + 2 * r * dy;
        if (r == 0 || i < 0 || j < 0 || i >= kSize.width || j >= kSize.height) continue;
        if (depth.at(i, j) == kInfinity) continue;
        const double apart =
            std::fabs(static_cast<double>(depth.at(i, j)) - static_cast<double>(depth.at(x, y)));
        const double weight = (0.3 + kGaussian[std::abs(r)]) * std::fmax(0, 1 - apart / limit);
        sum += value(i, j) * weight;
        total += weight;
    }
    return sum / total;
}

}  // namespace

TEST_CASE("SAO's blur: each texel is the published loop, across and then down") {
    const AoInputs inputs = uneven_inputs();
    Image<float> ao = noise_image(kSize, 9);
    std::vector<double> values, across;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            if (inputs.view_depth.at(x, y) == kInfinity) ao.at(x, y) = 1;
            values.push_back(static_cast<double>(ao.at(x, y)));
        }
    }
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x)
            across.push_back(along(values, inputs.view_depth, 0.15, x, y, 1, 0));
    }
    const Image<float> blurred = sao_blur(ao, inputs, {.quads = false, .fine = false}).ao;
    CHECK(pixels_against(kSize, [&](int x, int y) {
              if (inputs.view_depth.at(x, y) == kInfinity) return blurred.at(x, y) == 1;
              const double expected = along(across, inputs.view_depth, 0.15, x, y, 0, 1);
              return std::fabs(static_cast<double>(blurred.at(x, y)) - expected) < 1e-5;
          }) == "");
}

TEST_CASE("SAO's blur: an open map stays exactly open, and an even one as even as rounding leaves it") {
    const AoInputs inputs = uneven_inputs();
    CHECK(other_than(sao_blur(Image<float>(kSize, 1), inputs, {.iterations = 3}).ao, 1) == "");
    const Image<float> even = sao_blur(Image<float>(kSize, 0.3f), inputs, {.iterations = 3}).ao;
    CHECK(pixels_against(kSize, [&](int x, int y) {
              const float expected = inputs.view_depth.at(x, y) == kInfinity ? 1 : 0.3f;
              return std::fabs(even.at(x, y) - expected) < 1e-6f;
          }) == "");
    CHECK(content_hash(sao_blur(noise_image(kSize, 1), inputs, {.iterations = 0}).ao) ==
          content_hash(noise_image(kSize, 1)));
}

TEST_CASE("SAO's blur: texels as far apart as the limit keep apart; at 0 only equal depths count") {
    AoInputs inputs = plain_inputs(kSize, 3);
    Image<float> ao(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < 20; ++x) {
            inputs.view_depth.at(x, y) = 3.25f;
            ao.at(x, y) = 0;
        }
    }
    const Image<float>& depth = inputs.view_depth;
    const auto sides_keep = [&](float limit) {
        const Image<float> blurred = sao_blur(ao, inputs, {.depth = limit}).ao;
        return pixels_against(kSize,
                              [&](int x, int y) { return blurred.at(x, y) == (depth.at(x, y) > 3 ? 0 : 1); });
    };
    CHECK(sides_keep(0.25f) == "");
    CHECK(sides_keep(0) == "");
    CHECK(sides_keep(0.26f) != "");
}

TEST_CASE("SAO's blur: every second texel leaves dots, which the squares of four take away") {
    const AoInputs inputs = plain_inputs(kSize, 3);
    const Image<float> ao = noise_image(kSize, 4);
    const auto roughness = [&](bool quads) {
        const Image<float> blurred =
            sao_blur(ao, inputs, {.iterations = 2, .quads = quads, .fine = false}).ao;
        double sum = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x + 1 < kSize.width; ++x)
                sum += std::fabs(static_cast<double>(blurred.at(x, y)) -
                                 static_cast<double>(blurred.at(x + 1, y)));
        }
        return sum;
    };
    CHECK(roughness(true) < 0.6 * roughness(false));
    // Squares are those of even columns and rows; what lies too far apart is not evened out.
    AoInputs steps = inputs;
    Image<float> dotted(kSize, 1);
    dotted.at(2, 2) = 0;
    steps.view_depth.at(2, 2) = 4;
    CHECK(sao_blur(dotted, steps, {}).ao.at(2, 2) == 0);
    CHECK(sao_blur(dotted, steps, {}).ao.at(3, 3) == 1);
    CHECK(sao_blur(dotted, inputs, {.fine = false}).ao.at(3, 3) ==
          sao_blur(dotted, inputs, {.fine = false}).ao.at(2, 2));
}

TEST_CASE("SAO's blur: a dark column leaves stripes, which the fine pass takes away") {
    // Its own square lies half on another surface, as along a crease.
    AoInputs inputs = plain_inputs(kSize, 3);
    Image<float> ao(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < 21; ++x) inputs.view_depth.at(x, y) = 5;
        ao.at(21, y) = 0;
    }
    const auto stripes = [&](bool fine) {
        const Image<float> blurred = sao_blur(ao, inputs, {.fine = fine}).ao;
        // How much darker a column at an even distance is than its neighbours at odd ones.
        return (blurred.at(24, 18) + blurred.at(26, 18)) / 2 - blurred.at(25, 18);
    };
    CHECK(stripes(false) > 0.08f);
    CHECK(std::fabs(stripes(true)) < 0.02f);
}

TEST_CASE("SAO's blur: the other kind is X_Jun's; settings out of range are refused by name") {
    const AoInputs inputs = uneven_inputs();
    const Image<float> ao = noise_image(kSize, 3);
    BlurSettings xjun = kXjunBlur;
    xjun.iterations = 2;
    xjun.depth_threshold = 0.1f;
    const SaoBlurSettings bilateral{.kind = SaoBlurKind::bilateral, .iterations = 2, .depth = 0.1f};
    CHECK(content_hash(sao_blur(ao, inputs, bilateral).ao) ==
          content_hash(bilateral_blur(ao, inputs, xjun).ao));
    CHECK_THROWS_WITH_AS(validate(SaoBlurSettings{.iterations = 65}), doctest::Contains("blur_iterations"),
                         UsageError);
    CHECK_THROWS_WITH_AS(validate(SaoBlurSettings{.depth = -1}), doctest::Contains("blur_depth"), UsageError);
}
