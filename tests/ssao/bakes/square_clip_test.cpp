#include <doctest/doctest.h>

#include <algorithm>

#include "ssao/bakes/square_clip.h"
#include "tests/tools/ray_checks.h"

using namespace crevice;

namespace {
using Triangle = std::array<glm::dvec2, 3>;
}

TEST_CASE("middle in square: whole triangle, whole square, touching only") {
    const Triangle inside = {glm::dvec2(5.25, 7.25), {5.75, 7.25}, {5.5, 7.5}};
    const auto middle = middle_in_square(inside, {5, 7});
    REQUIRE(middle.has_value());
    CHECK(middle->x == doctest::Approx(5.5));
    CHECK(middle->y == doctest::Approx(22.0 / 3));
    const Triangle around = {glm::dvec2(-100, -100), {100, -100}, {0, 200}};
    CHECK(*middle_in_square(around, {3, 4}) == glm::dvec2(3.5, 4.5));
    CHECK(!middle_in_square(inside, {6, 7}));
    CHECK(!middle_in_square(inside, {5, 8}));
    const Triangle below = {glm::dvec2(0, 1), {1, 1}, {0, 2}}, corner = {glm::dvec2(1, 1), {2, 1}, {1, 2}};
    CHECK(!middle_in_square(below, {0, 0}));
    CHECK(middle_in_square(below, {0, 1}));
    CHECK(!middle_in_square(corner, {0, 0}));
}

TEST_CASE("middle in square: it lies in both, and thin triangles are found in every square they cross") {
    RandomNumbers random(11);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec2 a(random.in_cube(4)), along(random.in_cube(6)), b = a + along;
        const double width = i % 2 == 0 ? 1e-9 : 1.0;
        const Triangle t = {a, b, a + width * glm::dvec2(-along.y, along.x)};
        for (int step = 0; step <= 8; ++step) {
            // A point inside, and the square it falls into.
            const glm::dvec2 in =
                (1 - step / 9.0) * (0.9 * a + 0.1 * t[2]) + step / 9.0 * (0.9 * b + 0.1 * t[2]);
            const glm::dvec2 low(std::floor(in.x), std::floor(in.y));
            const auto middle = middle_in_square(t, low);
            CAPTURE(i);
            CAPTURE(step);
            REQUIRE(middle.has_value());
            const glm::dvec2 from = *middle - low;
            CHECK(std::min(from.x, from.y) >= -1e-9);
            CHECK(std::max(from.x, from.y) <= 1 + 1e-9);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec2 edge = t[(k + 1) % 3] - t[k], to = *middle - t[k];
                CHECK(edge.x * to.y - edge.y * to.x >= -1e-9);
            }
        }
    }
}
