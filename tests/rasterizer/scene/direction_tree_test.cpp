#include "rasterizer/scene/direction_tree.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

constexpr double kPi2 = 6.283185307179586;

std::vector<WeightedDirection> over_the_sphere(std::size_t count, RandomSequence& random) {
    std::vector<WeightedDirection> directions;
    while (directions.size() < count) {
        const glm::dvec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        if (glm::length(v) > 0.1) directions.push_back({glm::normalize(v), random.between(0, 1)});
    }
    return directions;
}
std::vector<WeightedDirection> on_a_circle(std::size_t count, double tilt, RandomSequence& random) {
    std::vector<WeightedDirection> directions;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = kPi2 * static_cast<double>(i) / static_cast<double>(count);
        directions.push_back(
            {glm::normalize(glm::dvec3(std::cos(angle), tilt, std::sin(angle))), random.between(0, 1)});
    }
    return directions;
}

}  // namespace

TEST_CASE("direction tree: the sum that adding one by one finds, for every kind of crowd and every angle") {
    RandomSequence random(7);
    std::vector<std::vector<WeightedDirection>> crowds = {
        {},
        over_the_sphere(1, random),
        over_the_sphere(9, random),
        over_the_sphere(5000, random),
        on_a_circle(5000, 0.5, random),
        std::vector<WeightedDirection>(3000, {{0, 0, 1}, 0.25})};
    crowds.push_back(over_the_sphere(500, random));
    crowds.back().resize(600);  // zeros, as of triangles without area: at right angles to everything
    for (const std::vector<WeightedDirection>& crowd : crowds) {
        const DirectionTree tree(crowd);
        for (const double least : {-2.0, -0.9, 0.0, 0.5, 0.99, 0.999999, 1.0}) {
            for (int i = 0; i < 20; ++i) {
                const glm::dvec3 axis = i < 10 && !crowd.empty()
                                            ? crowd[random.bits() % crowd.size()].direction
                                            : over_the_sphere(1, random)[0].direction;
                const DirectionSum expected = sum_within(crowd, axis, least);
                const DirectionSum found = tree.sum_within(axis, least);
                CAPTURE(crowd.size());
                CAPTURE(least);
                CAPTURE(axis.x);
                CAPTURE(axis.y);
                CAPTURE(axis.z);
                // Weights are positive: one direction too few or too many would show.
                CHECK(std::abs(found.weight - expected.weight) <= 1e-12 * expected.weight);
                CHECK(glm::length(found.sum - expected.sum) <= 1e-12 * expected.weight);
            }
        }
    }
}

TEST_CASE("direction tree: the order in which directions are given changes no bit") {
    RandomSequence random(11);
    std::vector<WeightedDirection> crowd = over_the_sphere(700, random);
    const DirectionTree given(crowd);
    for (std::size_t i = crowd.size() - 1; i > 0; --i) std::swap(crowd[i], crowd[random.bits() % (i + 1)]);
    const DirectionTree shuffled(crowd);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 axis = over_the_sphere(1, random)[0].direction;
        CAPTURE(i);
        CHECK(given.sum_within(axis, 0.3).sum == shuffled.sum_within(axis, 0.3).sum);
    }
}
