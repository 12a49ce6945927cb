// Which neighbours count in the blur: a fixed limit in depth, the distance from the centre's plane, or all.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "ssao/blur/bilateral_blur.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr Size kSize = {40, 60};

// A floor 3 below the eye, seen in perspective up to its horizon in the middle of the picture.
AoInputs grazing_floor() {
    AoInputs inputs = plain_inputs(kSize, 1);
    inputs.rays = {{0.3f, 0.45f}, kSize, true};
    for (int y = 0; y < kSize.height; ++y) {
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(kSize.height);
        const float ray_y = (1 - 2 * v) * inputs.rays.ray_scale.y;
        for (int x = 0; x < kSize.width; ++x) {
            inputs.view_depth.at(x, y) = ray_y < 0 ? 3 / -ray_y : kInfinity;
            inputs.normal.set(x, y, {0, ray_y < 0 ? 1 : 0, 0});
        }
    }
    return inputs;
}

// How many taps down a column the texel at its middle keeps: what a 0 in each of its neighbours takes away.
int taps_kept(const AoInputs& inputs, const BlurSettings& settings, int x, int y) {
    int kept = 0;
    for (int k = -kBlurRadius; k <= kBlurRadius; ++k) {
        if (k == 0) continue;
        Image<float> ao(inputs.size(), 1);
        ao.at(x, y + k) = 0;
        kept += bilateral_blur(ao, inputs, settings).ao.at(x, y) < 1;
    }
    return kept;
}

}  // namespace

TEST_CASE("slope: all ten taps on a grazing floor where the fixed limit keeps none") {
    const AoInputs inputs = grazing_floor();
    BlurSettings once{.iterations = 1};
    const int far_row = 36, near_row = 54;  // 3 / .0975 and 3 / .3675
    CHECK(taps_kept(inputs, once, 20, far_row) == 0);
    CHECK(taps_kept(inputs, once, 20, near_row) < 10);
    once.edges = BlurEdges::slope;
    CHECK(taps_kept(inputs, once, 20, far_row) == 10);
    CHECK(taps_kept(inputs, once, 20, near_row) == 10);
    once.edges = BlurEdges::none;
    CHECK(taps_kept(inputs, once, 20, far_row) == 10);
}

TEST_CASE("slope: the distance from either plane decides, exactly at the limit") {
    const auto with_neighbour = [](float z, glm::vec3 own, glm::vec3 other) {
        AoInputs inputs = plain_inputs({2, 1}, 1);
        inputs.view_depth.at(1, 0) = z;
        inputs.normal.set(0, 0, own);
        inputs.normal.set(1, 0, other);
        Image<float> ao({2, 1}, 0);
        ao.at(1, 0) = 1;
        BlurSettings settings{.iterations = 1, .normal_threshold = 0.5f, .depth_threshold = 0.25f};
        settings.edges = BlurEdges::slope;
        return bilateral_blur(ao, inputs, settings).ao.at(0, 0) > 0;
    };
    const glm::vec3 facing(0, 0, -1);
    CHECK(with_neighbour(1.25f, facing, facing));
    CHECK(with_neighbour(0.75f, facing, facing));
    CHECK(!with_neighbour(std::nextafter(1.25f, 2.0f), facing, facing));
    CHECK(!with_neighbour(std::nextafter(0.75f, 0.0f), facing, facing));
    // A pixel is a unit wide: at a slope of .75 the neighbour is .75 deeper, and .8 * .75 - .6 = 0 off.
    const glm::vec3 tilted(0.6f, 0, -0.8f);
    CHECK(with_neighbour(1.75f, tilted, tilted));
    CHECK(!with_neighbour(1.0f, tilted, tilted));
    CHECK(!with_neighbour(1.75f, tilted, facing));
    CHECK(!with_neighbour(1.75f, facing, tilted));
    CHECK(!with_neighbour(kInfinity, facing, glm::vec3(0)));
    CHECK(!with_neighbour(kInfinity, glm::vec3(0, 1, 0), glm::vec3(0, 1, 0)));
    CHECK(!with_neighbour(kNan, facing, facing));
}

TEST_CASE("slope: shade crosses no step between two parallel floors, nor a fold") {
    AoInputs inputs = plain_inputs({30, 12}, 5);
    Image<float> ao({30, 12}, 1);
    for (int y = 0; y < 12; ++y) {
        for (int x = 15; x < 30; ++x) {
            inputs.view_depth.at(x, y) = 5.5f;
            ao.at(x, y) = 0.5f;
        }
    }
    BlurSettings settings;
    settings.edges = BlurEdges::slope;
    CHECK(further_apart_than(1e-6, bilateral_blur(ao, inputs, settings).ao, ao) == "");
    for (int y = 0; y < 12; ++y) {
        for (int x = 15; x < 30; ++x) inputs.view_depth.at(x, y) = 5, inputs.normal.set(x, y, {1, 0, 0});
    }
    CHECK(further_apart_than(1e-6, bilateral_blur(ao, inputs, settings).ao, ao) == "");
    settings.edges = BlurEdges::none;
    CHECK(further_apart_than(0.1, bilateral_blur(ao, inputs, settings).ao, ao) != "");
}

TEST_CASE("none: the weights themselves in the middle of a map, whatever it shows") {
    const Size size = {31, 33};
    AoInputs inputs = plain_inputs(size, 5);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            inputs.view_depth.at(x, y) = noise(3, x, y) < 0.4f ? kInfinity : 100 * noise(4, x, y);
            inputs.normal.set(x, y, {noise(5, x, y) - 0.5f, noise(6, x, y) - 0.5f, -0.5f});
        }
    }
    Image<float> ao(size, 0);
    ao.at(15, 16) = 1;
    BlurSettings settings{.iterations = 1, .edges = BlurEdges::none};
    for (const KeptWork& kept : {KeptWork{}, KeptWork::all()}) {
        const Image<float> blurred = bilateral_blur(ao, inputs, settings, Run{.kept = kept}).ao;
        CHECK(pixels_against(size, [&](int x, int y) {
                  const int i = x - 15 + 5, j = y - 16 + 5;
                  const auto weight = [](int k) {
                      return k < 0 || k > 10
                                 ? 0.0
                                 : static_cast<double>(kXjunBlurWeights[static_cast<std::size_t>(k)]);
                  };
                  return std::fabs(static_cast<double>(blurred.at(x, y)) - weight(i) * weight(j)) < 1e-7;
              }) == "");
    }
}
