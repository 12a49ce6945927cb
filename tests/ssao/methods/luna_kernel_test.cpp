// The estimator's one text in its three number types: one pixel, eight pixels, and double.
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/run.h"
#include "rasterizer/lanes/wide_pairs.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// One texel as the kernel wants it.
struct Point {
    Vec3<float> p, n, random;
};
std::vector<Point> points_of(const PreparedStillLife& scene) {
    const LunaKernel kernel(scene.inputs, scene.settings);
    const RandomMap map = random_map(scene.settings.seed);
    std::vector<Point> points;
    const Size size = scene.inputs.size();
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float z = scene.inputs.view_depth.at(x, y);
            if (z == kInfinity) continue;
            const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size.width);
            const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height);
            const glm::vec3 n = scene.inputs.normal.at(x, y);
            points.push_back(
                {scene.inputs.rays.p_view(u, v, z), {n.x, n.y, n.z}, kernel.random_vector<float>(map, u, v)});
        }
    }
    while (points.size() % 8 != 0) points.pop_back();
    return points;
}

Vec3<double> exact(Vec3<float> a) { return {a.x, a.y, a.z}; }

}  // namespace

TEST_CASE("samples in float and in double agree, unless rounding puts one across a decision") {
    for (const TutorialMethod& method : kTutorialMethods) {
        CAPTURE(method.name);
        const PreparedStillLife scene(method);
        const LunaKernel kernel(scene.inputs, scene.settings);
        int samples = 0, across = 0;
        double worst = 0;
        for (const Point& point : points_of(scene)) {
            for (const glm::vec3& offset : kernel.offsets) {
                const double in_float = kernel.sample<float>(point.p, point.n, point.random, offset);
                const double in_double =
                    kernel.sample<double>(exact(point.p), exact(point.n), exact(point.random), offset);
                const double difference = std::fabs(in_float - in_double);
                ++samples;
                // Beside a silhouette the depth map is so steep that a rounded screen position shows.
                if (difference > 1e-4)
                    ++across;
                else
                    worst = std::fmax(worst, difference);
            }
        }
        CHECK(samples > 10000);
        CHECK(across * 1000 < samples);
        CHECK(worst < 1e-4);
        CHECK(worst > 0);
    }
}

TEST_CASE("several lanes of the kernel give the bits of one lane each, on every instruction set") {
    for (const TutorialMethod& method : kTutorialMethods) {
        const PreparedStillLife scene(method);
        const LunaKernel kernel(scene.inputs, scene.settings);
        const std::vector<Point> points = points_of(scene);
        std::vector<float> planes[9];
        for (const Point& point : points) {
            const float values[9] = {point.p.x, point.p.y,      point.p.z,      point.n.x,     point.n.y,
                                     point.n.z, point.random.x, point.random.y, point.random.z};
            for (std::size_t i = 0; i < 9; ++i) planes[i].push_back(values[i]);
        }
        for (const Isa isa : kEveryIsa) {
            if (!isa_available(isa)) continue;
            CAPTURE(method.name);
            CAPTURE(std::string(isa_name(isa)));
            std::vector<float> wide(points.size());
            call_for_isa(isa, [&]<class F>(Lanes<F>) {
                for (std::size_t i = 0; i < points.size(); i += kLanes<F>) {
                    const auto at = [&](std::size_t k) __attribute__((always_inline)) {
                        return load<F>(planes[k].data() + i);
                    };
                    const Vec3<F> p = {at(0), at(1), at(2)}, n = {at(3), at(4), at(5)},
                                  random = {at(6), at(7), at(8)};
                    store(wide.data() + i, kernel.accessibility<F>(p, n, random));
                }
            });
            int unlike = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const float one = kernel.accessibility<float>(points[i].p, points[i].n, points[i].random);
                unlike += float_bits(one) != float_bits(wide[i]);
            }
            CHECK(unlike == 0);
        }
    }
}

TEST_CASE_TEMPLATE("squares of pixels and pairs are loaded as one lane loads them", F, Wide<4>, Wide<8>) {
    const Image<float> image = noise_image({24, 9}, 17);
    const float* pixels = image.pixels.data();
    Int<F> index;
    for (int i = 0; i < kLanes<F>; ++i) index.v[i] = (5 * i + 3) % 8 * image.stride + 7 * i % 23;
    const Square<F> squares = gather_square(pixels, image.stride, index);
    const Pair<F> pairs = load_pairs<F>(pixels + 3);
    for (int i = 0; i < kLanes<F>; ++i) {
        CAPTURE(i);
        const Square<float> square = gather_square(pixels, image.stride, index[i]);
        CHECK(square.upper_left == pixels[index[i]]);
        CHECK(square.upper_right == pixels[index[i] + 1]);
        CHECK(square.lower_left == pixels[index[i] + image.stride]);
        CHECK(square.lower_right == pixels[index[i] + image.stride + 1]);
        CHECK(squares.upper_left[i] == square.upper_left);
        CHECK(squares.upper_right[i] == square.upper_right);
        CHECK(squares.lower_left[i] == square.lower_left);
        CHECK(squares.lower_right[i] == square.lower_right);
        const Pair<float> pair = load_pairs<float>(pixels + 3 + 2 * i);
        CHECK(pair.first == pixels[3 + 2 * i]);
        CHECK(pair.second == pixels[4 + 2 * i]);
        CHECK(pairs.first[i] == pair.first);
        CHECK(pairs.second[i] == pair.second);
    }
}

TEST_CASE("a texel's steps, a loop each, are the sum of its samples one by one") {
    for (const TutorialMethod& method : kTutorialMethods) {
        CAPTURE(method.name);
        const PreparedStillLife scene(method);
        for (const int samples : {1, 5, 14}) {
            CAPTURE(samples);
            LunaSettings settings = scene.settings;
            settings.samples = samples;
            const LunaKernel kernel(scene.inputs, settings);
            int unlike = 0, occluded = 0;
            for (const Point& point : points_of(scene)) {
                float sum = 0;
                for (int i = 0; i < samples; ++i) {
                    const glm::vec3& offset = kernel.offsets[static_cast<std::size_t>(i)];
                    sum = sum + kernel.sample<float>(point.p, point.n, point.random, offset);
                }
                const float one_by_one = 1 - sum / static_cast<float>(samples);
                unlike += kernel.accessibility<float>(point.p, point.n, point.random) != one_by_one;
                occluded += one_by_one < 1;
            }
            CHECK(unlike == 0);
            CHECK(occluded > 50);
        }
    }
}
