// Which neighbours the blur takes, and which settings it refuses.
#include "ssao/blur/bilateral_blur.h"

#include <array>
#include <cmath>
#include <functional>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr BlurWeights kDyadicWeights = {1 / 64.0f, 1 / 32.0f, 1 / 16.0f, 1 / 8.0f,  1 / 4.0f, 1 / 2.0f,
                                        1 / 4.0f,  1 / 8.0f,  1 / 16.0f, 1 / 32.0f, 1 / 64.0f};

}  // namespace

TEST_CASE("blur: nothing crosses an edge in depth or normal") {
    const Size size = {24, 18};
    const auto left = [](int x, int y) { return x < 11 || y < 5; };
    AoInputs depth_edge = plain_inputs(size, 5), normal_edge = depth_edge;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (left(x, y)) continue;
            depth_edge.view_depth.at(x, y) = 5.25f;
            normal_edge.normal.set(x, y, {0.65f, 0, -0.76f});
        }
    }
    for (const auto& sides : {std::array{0.5f, 0.25f}, {1.0f, 0.0f}, {0.3f, 0.9f}, {0.77f, 0.1f}}) {
        const float near = sides[0], far = sides[1];
        for (const int iterations : {1, 4}) {
            CAPTURE(near);
            CAPTURE(far);
            CAPTURE(iterations);
            Image<float> step(size, near);
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) step.at(x, y) = left(x, y) ? near : far;
            }
            const BlurSettings dyadic{.weights = kDyadicWeights, .iterations = iterations};
            const BlurSettings xjun{.iterations = iterations};
            // Sums of equal powers of two are exact with weights that are powers of two; otherwise a pass may
            // round each way.
            const bool exact = near == 0.5f || near == 1;
            const double bound = 2.4e-7 * iterations;  // two roundings in each of its two passes
            CHECK(further_apart_than(exact ? 0 : bound, bilateral_blur(step, depth_edge, dyadic).ao, step) ==
                  "");
            CHECK(further_apart_than(exact ? 0 : bound, bilateral_blur(step, normal_edge, dyadic).ao, step) ==
                  "");
            CHECK(further_apart_than(bound, bilateral_blur(step, depth_edge, xjun).ao, step) == "");
            // Without the edges it would.
            CHECK(further_apart_than(0.01, bilateral_blur(step, plain_inputs(size, 5), xjun).ao, step) != "");
        }
    }
}

TEST_CASE("blur: neighbours exactly at a threshold count, just beyond it they do not") {
    const auto with_neighbour = [](float z, glm::vec3 n) {
        AoInputs inputs = plain_inputs({2, 1}, 1);
        inputs.view_depth.at(1, 0) = z;
        inputs.normal.set(1, 0, n);
        Image<float> ao({2, 1}, 0);
        ao.at(1, 0) = 1;
        BlurSettings settings;
        settings.iterations = 1;
        settings.depth_threshold = 0.25f;
        settings.normal_threshold = 0.5f;
        return bilateral_blur(ao, inputs, settings).ao.at(0, 0) > 0;
    };
    CHECK(with_neighbour(1.25f, {0, 0, -1}));
    CHECK(with_neighbour(0.75f, {0, 0, -1}));
    CHECK(!with_neighbour(std::nextafter(1.25f, 2.0f), {0, 0, -1}));
    CHECK(!with_neighbour(std::nextafter(0.75f, 0.0f), {0, 0, -1}));
    CHECK(with_neighbour(1, {0, 0.8f, -0.5f}));
    CHECK(!with_neighbour(1, {0, 0.8f, std::nextafter(-0.5f, 0.0f)}));
    CHECK(!with_neighbour(kInfinity, {0, 0, 0}));
    CHECK(!with_neighbour(kNan, {0, 0, -1}));
    CHECK(!with_neighbour(1, {kNan, 0, -1}));
}

TEST_CASE("blur: settings out of their range are refused by name") {
    const auto refused = [](const char* name, const std::function<void(BlurSettings&)>& change) {
        CAPTURE(name);
        BlurSettings settings;
        change(settings);
        CHECK_THROWS_WITH_AS(bilateral_blur(noise_image({3, 3}, 36), plain_inputs({3, 3}, 5), settings),
                             doctest::Contains(name), UsageError);
    };
    refused("blur_iterations", [](BlurSettings& s) { s.iterations = -1; });
    refused("blur_iterations", [](BlurSettings& s) { s.iterations = 65; });
    for (const float bad : {-1.01f, 1.01f, kNan, kInfinity})
        refused("blur_normal", [=](BlurSettings& s) { s.normal_threshold = bad; });
    for (const float bad : {-0.01f, kNan, kInfinity})
        refused("blur_depth", [=](BlurSettings& s) { s.depth_threshold = bad; });
    for (const float bad : {0.0f, -0.1f, kNan, kInfinity})
        refused("blur weights", [=](BlurSettings& s) { s.weights[10] = bad; });
}
