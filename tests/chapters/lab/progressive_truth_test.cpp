// Truth that refines: unbiased however it is cut into pieces, and its errors are those that it tells.
#include <cmath>

#include <doctest/doctest.h>

#include "chapters/lab/progressive_truth.h"
#include "chapters/study/references.h"
#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

constexpr Size kSize = {48, 27};

RayAoSettings question() {
    RayAoSettings rays;
    rays.radius = 3;
    rays.fade = Fade{0.5f, 3};
    return rays;
}

ProgressiveTruth after(const Scene& scene, int passes, std::size_t points_at_once) {
    ProgressiveTruth truth(scene, scene.camera, kSize, question());
    while (truth.passes() < passes) truth.cast_from(points_at_once);
    return truth;
}

// The mean of both images' squared difference, and what it should be if their errors are told rightly.
struct Spread {
    double found = 0, told = 0;
};
Spread spread_of(const ReferenceImage& a, const Image<float>& b, const Image<float>& error_of_b) {
    Spread spread;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const double difference = double(a.mean.at(x, y)) - b.at(x, y);
            spread.found += difference * difference;
            spread.told += std::pow(double(a.error.at(x, y)), 2) + std::pow(double(error_of_b.at(x, y)), 2);
        }
    }
    return spread;
}

}  // namespace

TEST_CASE("progressive truth: it comes to the reference of a study, as near as both errors say") {
    const Scene scene = columns_scene();
    ReferenceRequest request;
    request.size = kSize;
    request.method = &find_method("xjun");
    request.settings = defaults_of(*request.method);
    request.rays = question();
    request.rays.fade.reset();
    request.rays.rays = 512;
    request.limit_seeds = 0;
    const References references = make_references(scene, scene.camera, request);
    RayAoSettings hard = question();
    hard.fade.reset();
    ProgressiveTruth truth(scene, scene.camera, kSize, hard);
    while (truth.passes() < 32) truth.cast_from(500);
    const Spread spread =
        spread_of(truth.reference(), references.hard.image.mean, references.hard.image.error);
    CHECK(spread.found > 0);
    CHECK(spread.found < 1.5 * spread.told);
}

TEST_CASE("progressive truth: pieces of any size make independent estimates of one picture") {
    const Scene scene = columns_scene();
    const ReferenceImage whole = after(scene, 24, 1 << 20).reference();
    const ReferenceImage pieces = after(scene, 24, 100).reference();
    const Spread spread = spread_of(whole, pieces.mean, pieces.error);
    CHECK(spread.found > 0.5 * spread.told);
    CHECK(spread.found < 1.5 * spread.told);
}

TEST_CASE("progressive truth: the mean is that of its halves, and more passes have smaller errors") {
    const Scene scene = columns_scene();
    const ReferenceImage few = after(scene, 4, 1000).reference(), many = after(scene, 32, 1000).reference();
    double error_of_few = 0, error_of_many = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            const double halves = 0.5 * (double(many.half[0].at(x, y)) + many.half[1].at(x, y));
            CHECK(double(many.mean.at(x, y)) == doctest::Approx(halves).epsilon(1e-6));
            error_of_few += few.error.at(x, y);
            error_of_many += many.error.at(x, y);
        }
    }
    CHECK(error_of_many < 0.6 * error_of_few);
}

TEST_CASE("progressive truth: a picture without a surface is open at once") {
    const Scene scene = empty_scene();
    ProgressiveTruth truth(scene, scene.camera, kSize, question());
    CHECK(truth.cast_from(1));
    CHECK(truth.cast_from(1));
    CHECK(truth.reference().mean.at(3, 4) == 1);
    CHECK(truth.reference().error.at(3, 4) == 0);
}
