// Whether the standard errors that references state are those they have.
#include <cmath>

#include <doctest/doctest.h>

#include "ssao/rays/ray_cast_ao.h"
#include "tests/tools/closed_form_shapes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr int kSeeds = 64;

// Points on a floor with a wall of height 1, from near to far: answers from a half to one.
struct WallScene {
    std::shared_ptr<const RayScene> scene =
        scene_of_shapes({rectangle({0, -1, -64}, {0, 2, 0}, {0, 0, 128})});
    std::vector<SurfacePoint> points;

    WallScene() {
        for (const double x : {0.25, 0.5, 1.0, 1.5, 2.0, 3.0})
            points.push_back({placed({x, 0, 0}), {0, 1, 0}, {0, 1, 0}});
    }
};

// The references of one point under many seeds.
struct Estimates {
    std::vector<AoEstimate> of_seed;

    double mean() const {
        double sum = 0;
        for (const AoEstimate& e : of_seed) sum += static_cast<double>(e.mean);
        return sum / kSeeds;
    }
    // Of the means over all seeds.
    double variance() const {
        const double centre = mean();
        double sum = 0;
        for (const AoEstimate& e : of_seed)
            sum += (static_cast<double>(e.mean) - centre) * (static_cast<double>(e.mean) - centre);
        return sum / (kSeeds - 1);
    }
    double stated_variance() const {
        double sum = 0;
        for (const AoEstimate& e : of_seed)
            sum += static_cast<double>(e.error) * static_cast<double>(e.error);
        return sum / kSeeds;
    }
};

std::vector<Estimates> estimates(const WallScene& wall, RayAoSettings settings) {
    std::vector<Estimates> result(wall.points.size());
    for (settings.seed = 1; settings.seed <= kSeeds; ++settings.seed) {
        const RayAoReference reference = ray_cast_reference(*wall.scene, wall.points, settings, nullptr);
        for (std::size_t i = 0; i < result.size(); ++i) result[i].of_seed.push_back(reference.hard[i]);
    }
    return result;
}

RayAoSettings settings_of(RaySequence sequence, RayWeight weight) {
    RayAoSettings settings;
    settings.rays = 512;
    settings.radius = kInfinity;
    settings.sequence = sequence;
    settings.weight = weight;
    return settings;
}

}  // namespace

TEST_CASE("over 64 seeds the means spread as their standard errors say") {
    const WallScene wall;
    for (const RaySequence sequence : {RaySequence::sobol, RaySequence::independent}) {
        for (const RayWeight weight : {RayWeight::cosine, RayWeight::uniform}) {
            double pooled = 0;
            const std::vector<Estimates> all = estimates(wall, settings_of(sequence, weight));
            for (std::size_t i = 0; i < all.size(); ++i) {
                const double ratio = all[i].variance() / all[i].stated_variance();
                INFO("sequence " << static_cast<int>(sequence) << ", weight " << static_cast<int>(weight)
                                 << ", point " << i << ", variance " << all[i].variance() << ", ratio "
                                 << ratio);
                // Chi-square of 63 degrees of freedom over 63 lies in [0.47, 1.84] but once in 10,000 times;
                // the denominator's own 448 degrees add a tenth.
                CHECK(ratio > 0.42);
                CHECK(ratio < 2.0);
                pooled += ratio / static_cast<double>(all.size());
            }
            CHECK(pooled > 0.75);
            CHECK(pooled < 1.3);
        }
    }
}

TEST_CASE("random rays have the binomial law's variance, a low-discrepancy sequence a small part of it") {
    const WallScene wall;
    for (const RayWeight weight : {RayWeight::cosine, RayWeight::uniform}) {
        const RayAoSettings random = settings_of(RaySequence::independent, weight);
        const std::vector<Estimates> independent = estimates(wall, random),
                                     sobol = estimates(wall, settings_of(RaySequence::sobol, weight));
        for (std::size_t i = 0; i < wall.points.size(); ++i) {
            CAPTURE(i);
            const double open = independent[i].mean(), binomial = open * (1 - open) / random.rays;
            CHECK(independent[i].stated_variance() > 0.7 * binomial);
            CHECK(independent[i].stated_variance() < 1.35 * binomial);
            CHECK(sobol[i].stated_variance() < 0.35 * binomial);
        }
    }
}

TEST_CASE("the two halves of a reference are independent of each other and make up its mean") {
    const WallScene wall;
    for (const RaySequence sequence : {RaySequence::sobol, RaySequence::independent}) {
        CAPTURE(static_cast<int>(sequence));
        double product = 0, squares = 0;
        int count = 0;
        for (const Estimates& point : estimates(wall, settings_of(sequence, RayWeight::cosine))) {
            const double centre = point.mean();
            for (const AoEstimate& e : point.of_seed) {
                const double a = static_cast<double>(e.half[0]) - centre,
                             b = static_cast<double>(e.half[1]) - centre;
                CHECK(std::abs((a + b) / 2 - (static_cast<double>(e.mean) - centre)) < 1e-6);
                product += a * b;
                squares += (a * a + b * b) / 2;
                ++count;
            }
        }
        const double correlation = product / squares;
        CAPTURE(correlation);
        CHECK(std::abs(correlation) < 4 / std::sqrt(count));
    }
}
