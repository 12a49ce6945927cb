// The way from a normal map to a surface: bumped_normal of tangents.h.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/scene/tangents.h"

using namespace crevice;

namespace {

Vec3<float> vec(glm::vec3 v) { return {v.x, v.y, v.z}; }

glm::vec3 bumped(glm::vec3 n, glm::vec3 tangent, float handedness, glm::vec3 n_tangent) {
    const Vec3<float> result = bumped_normal<float>(vec(n), vec(tangent), handedness, vec(n_tangent));
    return {result.x, result.y, result.z};
}

bool close(glm::vec3 a, glm::vec3 b) { return glm::length(a - b) < 1e-6f; }

}  // namespace

TEST_CASE("bumped_normal: the map's axes are tangent, bitangent and normal") {
    const glm::vec3 n(0, 0, -1), right(1, 0, 0), down(0, -1, 0);
    CHECK(close(bumped(n, right, 1, {0, 0, 1}), n));
    CHECK(close(bumped(n, right, 1, {1, 0, 0}), right));
    CHECK(close(bumped(n, right, 1, {0, 1, 0}), down));
    CHECK(close(bumped(n, right, -1, {0, 1, 0}), -down));
    CHECK(close(bumped(n, right, -0.25f, {0, 1, 0}), -down));
    CHECK(close(bumped(n, right, 1, {0.6f, 0, 0.8f}), {0.6f, 0, -0.8f}));
    // A tangent that interpolation has shortened and tilted.
    CHECK(close(bumped(n, {0.3f, 0, -0.2f}, 1, {0, 1, 0}), down));
}

TEST_CASE("bumped_normal: without a tangent only the vertex normal is left") {
    const glm::vec3 n(0.6f, 0, 0.8f);
    CHECK(close(bumped(n, glm::vec3(0), 1, {0.6f, 0, 0.8f}), n));
    CHECK(close(bumped(n, 2.0f * n, 1, {0.6f, 0, 0.8f}), n));
    CHECK(close(bumped(n, glm::vec3(0), 1, {1, 0, 0}), n));
}

TEST_CASE("bumped_normal: lengths and angles are kept, one lane as eight") {
    for (int i = 0; i < 100; ++i) {
        const float a = static_cast<float>(i);
        const glm::vec3 n = glm::normalize(glm::vec3(std::sin(a), std::cos(3 * a), std::sin(7 * a) + 0.1f)),
                        tangent(std::cos(2 * a), std::sin(5 * a), 0.7f),
                        map = glm::normalize(glm::vec3(std::sin(4 * a), std::cos(a), 1));
        const float handedness = i % 2 == 0 ? 1.0f : -1.0f;
        const glm::vec3 result = bumped(n, tangent, handedness, map);
        CAPTURE(i);
        CHECK(std::abs(glm::length(result) - 1) < 1e-6f);
        CHECK(std::abs(glm::dot(result, n) - map.z) < 1e-5f);
        const Vec3<Wide<8>> wide = bumped_normal<Wide<8>>(spread<Wide<8>>(n), spread<Wide<8>>(tangent),
                                                          Wide<8>(handedness), spread<Wide<8>>(map));
        CHECK(glm::vec3(wide.x[5], wide.y[5], wide.z[5]) == result);
    }
}

TEST_CASE("mapped_normal: red is along u, green along v, blue out; it is unit") {
    const auto is = [](glm::vec3 colour, glm::vec3 wanted) {
        const Vec3<float> n = mapped_normal<float>({colour.x, colour.y, colour.z});
        return glm::length(glm::vec3(n.x, n.y, n.z) - wanted) < 1e-6f;
    };
    CHECK(is({0.5f, 0.5f, 1}, {0, 0, 1}));
    CHECK(is({1, 0.5f, 0.5f}, {1, 0, 0}));
    CHECK(is({0.5f, 1, 0.5f}, {0, 1, 0}));
    CHECK(is({0.8f, 0.5f, 0.9f}, {0.6f, 0, 0.8f}));
    CHECK(is({0.65f, 0.5f, 0.7f}, {0.6f, 0, 0.8f}));  // shortened by a filter
    CHECK(is({0.5f, 0.5f, 0.5f}, {0, 0, 1}));         // averaged away
}
