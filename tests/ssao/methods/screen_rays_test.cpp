// Rays over the screen: their turns and shifts, and pixels beside them.
#include "ssao/methods/screen_rays.h"

#include <cmath>
#include <set>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

TEST_CASE("ray noise: 4 x 4 turns and shifts, one in each sixteenth, in an order of the seed's") {
    constexpr int kDirections = 6;
    std::set<std::vector<int>> orders;
    for (const std::uint32_t seed : {1u, 2u, 3u, 0xffffffffu}) {
        const RayNoise noise(seed, kDirections);
        std::set<int> turns, shifts;
        std::vector<int> order;
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) {
                const double cosine = noise.cosine.at<float>(x, y), sine = noise.sine.at<float>(x, y);
                CHECK(std::fabs(std::hypot(cosine, sine) - 1) < 1e-6);
                turns.insert(static_cast<int>(std::atan2(sine, cosine) * kDirections / (2 * kPi) * 16));
                const float shift = noise.shift.at<float>(x, y);
                CHECK(shift >= 0);
                CHECK(shift < 1);
                order.push_back(static_cast<int>(shift * 16));
                shifts.insert(order.back());
                CHECK(noise.shift.at<float>(x + 12, y + 8) == shift);
            }
        }
        CHECK(turns.size() == 16);
        CHECK(shifts.size() == 16);
        orders.insert(order);
    }
    CHECK(orders.size() == 4);
}

TEST_CASE("ray distances: apart from the texel, evenly spaced, within the radius and a pixel") {
    for (const float shift : {0.0f, 0.5f, 0.999f}) {
        for (int step = 0; step < 4; ++step) {
            const float at = ray_distance_px(step, 4, shift, 50.0f);
            CHECK(at >= 1);
            CHECK(at < 50 * 0.8f + 1);
            if (step > 0) CHECK(std::fabs(at - ray_distance_px(step - 1, 4, shift, 50.0f) - 10) < 1e-4f);
        }
        CHECK(ray_distance_px(3, 4, shift, 0.0f) == 1);
    }
}

TEST_CASE("beside a ray a direction keeps its angle above the plane beneath it") {
    RandomSequence random(1);
    const auto as_vec3 = [](glm::dvec3 a) {
        return Vec3<float>{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
    };
    const glm::dvec3 v(0, 0, -1);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 some{random.between(-1, 1), random.between(-1, 1), -random.between(0.2, 1)};
        const glm::dvec3 n = glm::normalize(some);
        const double azimuth = random.between(0, 6.28), own = azimuth + random.between(-0.4, 0.4);
        const auto across = [](double angle) { return glm::dvec3(std::cos(angle), std::sin(angle), 0); };
        // Elevations of the plane in the ray's direction and beside it.
        const auto elevation = [&](double angle) { return std::atan2(-glm::dot(n, across(angle)), -n.z); };
        const double above = random.between(0, 1) * (1.4 - elevation(own));
        const double height = elevation(own) + above;
        const glm::dvec3 d = std::cos(height) * across(own) + std::sin(height) * v;
        const double gamma = std::atan2(glm::dot(n, across(azimuth)), -n.z);
        const double cosine =
            cosine_beside<float>(as_vec3(d), as_vec3(n), as_vec3(v), static_cast<float>(std::cos(gamma)),
                                 static_cast<float>(std::sin(gamma)));
        CHECK(std::fabs(cosine - std::sin(elevation(azimuth) + above)) < 1e-4);
    }
}
