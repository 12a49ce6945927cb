#include "ssao/blur/bilateral_blur.h"

#include <cmath>
#include <memory>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/image_summary.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr BlurWeights kDyadicWeights = {1 / 64.0f, 1 / 32.0f, 1 / 16.0f, 1 / 8.0f,  1 / 4.0f, 1 / 2.0f,
                                        1 / 4.0f,  1 / 8.0f,  1 / 16.0f, 1 / 32.0f, 1 / 64.0f};

// Bumps and steps: neighbours that count and neighbours that do not, in all mixtures, and some sky.
AoInputs rough_inputs(Size size) {
    AoInputs inputs = plain_inputs(size, 5);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            inputs.view_depth.at(x, y) =
                5 + 0.15f * noise(31, x, y) + (noise(32, x / 3, y / 2) > 0.7f ? 1.0f : 0.0f);
            inputs.normal.set(
                x, y,
                glm::normalize(glm::vec3(noise(33, x / 2, y) - 0.5f, noise(34, x, y / 2) - 0.5f, -0.6f)));
            if (noise(35, x / 4, y / 4) > 0.85f) {
                inputs.view_depth.at(x, y) = kInfinity;
                inputs.normal.set(x, y, glm::vec3(0));
            }
        }
    }
    return inputs;
}

// The tutorials' loop, in double: horizontal then vertical; taps outside do not count.
Image<float> blurred_in_double(const Image<float>& ao, const AoInputs& inputs, const BlurSettings& settings) {
    const Size size = ao.size;
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * size.width + x); };
    std::vector<double> front(at(0, size.height)), back(front.size());
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) front[at(x, y)] = ao.at(x, y);
    }
    for (int pass = 0; pass < 2 * settings.iterations; ++pass) {
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                double sum = 0, total = 0;
                for (int k = -5; k <= 5; ++k) {
                    const int tx = pass % 2 == 0 ? x + k : x, ty = pass % 2 == 0 ? y : y + k;
                    if (tx < 0 || ty < 0 || tx >= size.width || ty >= size.height) continue;
                    const double dz = std::fabs(static_cast<double>(inputs.view_depth.at(tx, ty)) -
                                                static_cast<double>(inputs.view_depth.at(x, y)));
                    const double cosine =
                        glm::dot(glm::dvec3(inputs.normal.at(tx, ty)), glm::dvec3(inputs.normal.at(x, y)));
                    const bool counts = k == 0 || (cosine >= static_cast<double>(settings.normal_threshold) &&
                                                   dz <= static_cast<double>(settings.depth_threshold));
                    if (!counts) continue;
                    const double w = settings.weights[static_cast<std::size_t>(k + 5)];
                    sum += w * front[at(tx, ty)];
                    total += w;
                }
                back[at(x, y)] = sum / total;
            }
        }
        std::swap(front, back);
    }
    Image<float> result(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) result.at(x, y) = static_cast<float>(front[at(x, y)]);
    }
    return result;
}

Image<float> mirrored(const Image<float>& image, bool in_x) {
    Image<float> result(image.size, 0);
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            result.at(x, y) =
                image.at(in_x ? image.size.width - 1 - x : x, in_x ? y : image.size.height - 1 - y);
        }
    }
    return result;
}

AoInputs mirrored(AoInputs inputs, bool in_x) {
    for (Image<float>* plane : {&inputs.view_depth, &inputs.normal.x, &inputs.normal.y, &inputs.normal.z})
        *plane = mirrored(*plane, in_x);
    return inputs;
}

}  // namespace

TEST_CASE("blur: every size and both tutorials' weights against their loop in double") {
    for (const Size size : {Size{1, 1}, {1, 19}, {23, 1}, {3, 5}, {8, 8}, {37, 23}, {64, 11}}) {
        for (const BlurSettings& settings : {kXjunBlur, kLunaBlur, BlurSettings{.iterations = 1}}) {
            CAPTURE(size.width);
            CAPTURE(size.height);
            CAPTURE(settings.iterations);
            const AoInputs inputs = rough_inputs(size);
            const Image<float> ao = noise_image(size, 36);
            CHECK(further_apart_than(1e-6, bilateral_blur(ao, inputs, settings).ao,
                                     blurred_in_double(ao, inputs, settings)) == "");
        }
    }
}

TEST_CASE("blur: where everything is open it stays exactly open, with any edges, weights and formats") {
    for (const BlurWeights& weights : {kXjunBlurWeights, kLunaBlurWeights, kDyadicWeights}) {
        for (const BufferFormat format :
             {BufferFormat::float32, BufferFormat::float16_toward_zero, BufferFormat::float16_nearest_even}) {
            BlurSettings settings{.weights = weights};
            settings.format = format;
            CAPTURE(static_cast<int>(format));
            CHECK(other_than(bilateral_blur(Image<float>({37, 23}, 1), rough_inputs({37, 23}), settings).ao,
                             1) == "");
            CHECK(other_than(bilateral_blur(Image<float>({37, 23}, 0), rough_inputs({37, 23}), settings).ao,
                             0) == "");
        }
    }
}

TEST_CASE("blur: 0 iterations and pictures of one pixel leave the map as it is") {
    const Image<float> ao = noise_image({19, 7}, 36);
    CHECK(content_hash(bilateral_blur(ao, rough_inputs({19, 7}), BlurSettings{.iterations = 0}).ao) ==
          content_hash(ao));
    for (const float value : {0.0f, 0.25f, 1.0f}) {
        CHECK(bilateral_blur(Image<float>({1, 1}, value), plain_inputs({1, 1}, 5)).ao.at(0, 0) == value);
    }
}

TEST_CASE("blur: taps outside the map never count, even with thresholds that let everything else pass") {
    const Size size = {7, 6};
    BlurSettings everything;
    everything.normal_threshold = -1;
    everything.depth_threshold = 1e30f;
    const Image<float> ao = noise_image(size, 36);
    const AoInputs inputs = plain_inputs(size, 5);
    CHECK(further_apart_than(1e-6, bilateral_blur(ao, inputs, everything).ao,
                             blurred_in_double(ao, inputs, everything)) == "");
    CHECK(other_than(bilateral_blur(Image<float>(size, 0), inputs, everything).ao, 0) == "");
    // Sky beside sky: nothing but itself.
    AoInputs sky = inputs;
    sky.view_depth = Image<float>(size, kInfinity);
    sky.normal = Image3(size, glm::vec3(0));
    CHECK(further_apart_than(1e-6, bilateral_blur(ao, sky, everything).ao, ao) == "");
}

TEST_CASE("blur: a mirrored picture gives the mirrored result") {
    const Size size = {37, 23};
    const AoInputs inputs = rough_inputs(size);
    Image<float> ao = noise_image(size, 36);
    for (const bool in_x : {true, false}) {
        CAPTURE(in_x);
        const Image<float> expected = mirrored(bilateral_blur(ao, inputs).ao, in_x);
        CHECK(further_apart_than(1e-6, bilateral_blur(mirrored(ao, in_x), mirrored(inputs, in_x)).ao,
                                 expected) == "");
    }
    // Sums of the first pass are exact when values and weights are sums of few powers of two: then the bits
    // are equal too.
    for (float& a : ao.pixels) a = std::floor(a * 256) / 256;
    const BlurSettings exact{.weights = kDyadicWeights, .iterations = 1};
    const Image<float> expected = mirrored(bilateral_blur(ao, inputs, exact).ao, true);
    CHECK(further_apart_than(0, bilateral_blur(mirrored(ao, true), mirrored(inputs, true), exact).ao,
                             expected) == "");
}

TEST_CASE("blur: eleven symmetric weights, and none read beyond them (trap 8: the book reads a twelfth)") {
    for (const BlurWeights& weights : {kXjunBlurWeights, kLunaBlurWeights}) {
        REQUIRE(weights.size() == 11);
        double sum = 0;
        for (std::size_t i = 0; i < 11; ++i) {
            CHECK(weights[i] == weights[10 - i]);
            sum += static_cast<double>(weights[i]);
        }
        CHECK(std::fabs(sum - 1) < 1e-6);
    }
    for (std::size_t i = 0; i < 11; ++i) {
        double gaussians = 0;
        for (int k = -5; k <= 5; ++k) gaussians += std::exp(-k * k / (2 * 2.5 * 2.5));
        const double offset = static_cast<double>(i) - 5;
        CHECK(std::fabs(static_cast<double>(kLunaBlurWeights[i]) -
                        std::exp(-offset * offset / 12.5) / gaussians) < 1e-8);
    }
    // On the heap, where a sanitizer sees a read past the end.
    const auto settings = std::make_unique<BlurSettings>();
    const Image<float> blurred =
        bilateral_blur(noise_image({9, 9}, 36), plain_inputs({9, 9}, 5), *settings).ao;
    CHECK(outside_unit_interval(blurred) == "");
}
