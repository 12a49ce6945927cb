// LearnOpenGL's box blur: its taps, its half texel, and the bilateral blur in its place.
#include "ssao/blur/box_blur.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"

using namespace crevice;

namespace {

constexpr Size kSize = {37, 23};

// One closed texel in the middle of an open map.
Image<float> dot_map() {
    Image<float> ao(kSize, 1);
    ao.at(18, 11) = 0;
    return ao;
}

double moment(const Image<float>& ao, bool across) {
    double sum = 0, weighted = 0;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            const double closed = 1 - static_cast<double>(ao.at(x, y));
            sum += closed;
            weighted += closed * (across ? x : y);
        }
    }
    return weighted / sum;
}

double setting(const Denoiser& denoiser, const AnySettings& settings, const std::string& name) {
    const auto p = std::find_if(denoiser.parameters.begin(), denoiser.parameters.end(),
                                [&](const auto& parameter) { return parameter.name == name; });
    REQUIRE(p != denoiser.parameters.end());
    return p->get(settings);
}
AnySettings with(const Denoiser& denoiser, const std::string& name, double value,
                 AnySettings settings = box_denoiser().defaults) {
    setting(denoiser, settings, name);
    for (const auto& parameter : denoiser.parameters) {
        if (parameter.name == name) parameter.set(settings, value);
    }
    return settings;
}

}  // namespace

TEST_CASE("box blur: as published sixteen texels from two before to one after, half a texel off") {
    const Image<float> blurred = box_blur(dot_map(), plain_inputs(kSize, 5), {.shift = true}).ao;
    CHECK(pixels_against(kSize, [&](int x, int y) {
              // Of texel (x, y) the box holds x - 2 ... x + 1.
              const bool within = x >= 17 && x <= 20 && y >= 10 && y <= 13;
              return blurred.at(x, y) == (within ? 15.0f / 16 : 1.0f);
          }) == "");
    CHECK(moment(blurred, true) == doctest::Approx(18.5));
    CHECK(moment(blurred, false) == doctest::Approx(11.5));
}

TEST_CASE("box blur: centred it is the mean of the four boxes around the texel, and moves nothing") {
    const AoInputs inputs = plain_inputs(kSize, 5);
    const Image<float> dot = box_blur(dot_map(), inputs, {}).ao;
    CHECK(moment(dot, true) == doctest::Approx(18));
    CHECK(moment(dot, false) == doctest::Approx(11));
    const Image<float> noisy = noise_image(kSize, 3), centred = box_blur(noisy, inputs, {}).ao,
                       shifted = box_blur(noisy, inputs, {.shift = true}).ao;
    CHECK(pixels_against(kSize, [&](int x, int y) {
              if (x < 2 || y < 2 || x > kSize.width - 4 || y > kSize.height - 4) return true;
              const float mean = (shifted.at(x, y) + shifted.at(x + 1, y) + shifted.at(x, y + 1) +
                                  shifted.at(x + 1, y + 1)) /
                                 4;
              return std::fabs(centred.at(x, y) - mean) < 1e-6f;
          }) == "");
}

TEST_CASE("box blur: a pattern of four by four becomes even, whichever box") {
    Image<float> tile(kSize);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) tile.at(x, y) = noise(9, x % 4, y % 4);
    }
    for (const bool shift : {false, true}) {
        const Image<float> blurred = box_blur(tile, plain_inputs(kSize, 5), {.shift = shift}).ao;
        CHECK(pixels_against(kSize, [&](int x, int y) {
                  const bool inside = x >= 2 && y >= 2 && x < kSize.width - 2 && y < kSize.height - 2;
                  return !inside || std::fabs(blurred.at(x, y) - blurred.at(2, 2)) < 1e-6f;
              }) == "");
    }
}

TEST_CASE(
    "box blur: open stays exactly open, background too, and the outermost texels go on beyond the map") {
    AoInputs inputs = plain_inputs(kSize, 5);
    CHECK(other_than(box_blur(Image<float>(kSize, 1), inputs, {.iterations = 5}).ao, 1) == "");
    CHECK(other_than(box_blur(Image<float>(kSize, 0), inputs, {.iterations = 5}).ao, 0) == "");
    inputs.view_depth.at(19, 11) = kInfinity;
    const Image<float> beside_sky = box_blur(dot_map(), inputs, {}).ao;
    CHECK(beside_sky.at(19, 11) == 1);
    CHECK(beside_sky.at(17, 11) < 1);
    const Image<float> one = box_blur(Image<float>({1, 1}, 0.25f), plain_inputs({1, 1}, 5), {}).ao;
    CHECK(one.at(0, 0) == 0.25f);
}

TEST_CASE("box blur: no iterations leave the map, more blur further, and every run gives the same bits") {
    const Image<float> noisy = noise_image(kSize, 4);
    const AoInputs inputs = plain_inputs(kSize, 5);
    CHECK(content_hash(box_blur(noisy, inputs, {.iterations = 0}).ao) == content_hash(noisy));
    const auto spread = [&](int iterations) {
        const Image<float> blurred = box_blur(noisy, inputs, {.iterations = iterations}).ao;
        const auto [low, high] = std::minmax_element(blurred.row(11), blurred.row(11) + kSize.width);
        return *high - *low;
    };
    CHECK(spread(3) < spread(1));
    const std::string plain = content_hash(box_blur(noisy, inputs, {.iterations = 2}, kOneLane).ao);
    for_every_run({.threads = {1, 3}}, [&](const Run& run) {
        CHECK(content_hash(box_blur(noisy, inputs, {.iterations = 2}, run).ao) == plain);
    });
}

TEST_CASE("box denoiser: the bilateral blur can be chosen, and stops at an edge where the box does not") {
    const Denoiser denoiser = box_denoiser();
    RawAo raw{Image<float>(kSize, 1), TileMap(kSize, 16), plain_inputs(kSize, 5)};
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < 18; ++x) {
            raw.ao.at(x, y) = 0.5f;
            raw.inputs.view_depth.at(x, y) = 2;
        }
    }
    const auto beyond_edge = [&](const AnySettings& settings) {
        return denoiser.denoised(raw, settings, {}).ao.at(18, 11);
    };
    CHECK(beyond_edge(denoiser.defaults) < 1);
    const AnySettings bilateral = with(denoiser, "blur_kind", 1);
    CHECK(beyond_edge(bilateral) == 1);
    CHECK(beyond_edge(with(denoiser, "blur_depth", 10, bilateral)) < 1);
    CHECK(beyond_edge(with(denoiser, "blur_iterations", 0)) == 1);
    CHECK(content_hash(denoiser.denoised(raw, bilateral, {}).ao) ==
          content_hash(bilateral_blur(raw.ao, raw.inputs, {.iterations = 1}).ao));
    CHECK(beyond_edge(with(denoiser, "blur_shift", 1)) != beyond_edge(denoiser.defaults));
    for (const auto& [name, value] : {std::pair{"blur_iterations", 65.0}, std::pair{"blur_iterations", -1.0},
                                      std::pair{"blur_normal", 2.0}, std::pair{"blur_depth", -1.0}})
        CHECK_THROWS_WITH_AS(denoiser.validate(with(denoiser, name, value)), doctest::Contains(name),
                             UsageError);
}
