// Highlights that are left out because they cannot be seen: the bits of a surface lit with and without them.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "ssao/light/lighting.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

glm::vec3 random_vec3(RandomSequence& random, double low, double high) {
    return {random.between(low, high), random.between(low, high), random.between(low, high)};
}
glm::dvec3 random_direction(RandomSequence& random) {
    glm::dvec3 v(0);
    while (glm::dot(v, v) < 0.01) v = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    return glm::normalize(v);
}

Vec3<float> kernel_vector(const glm::dvec3& v) { return spread<float>(glm::vec3(v)); }

// One light on one point.
struct Lit {
    Material material;
    LitPoint<float> point;
    ViewLight light;
    glm::vec3 ambient_light;
    double cosine;  // between normal and half vector

    Vec3<float> colour(float no_highlight_below) const {
        return blinn_schlick(point, material, {light}, ambient_light, no_highlight_below);
    }
};

// Light and eye mirror each other about a half vector that makes `cosine` with the normal.
Lit lit_at(RandomSequence& random, const Material& material, double cosine) {
    const glm::dvec3 n = random_direction(random);
    const glm::dvec3 across = glm::normalize(glm::cross(n, random_direction(random)));
    const glm::dvec3 half = cosine * n + std::sqrt(1 - cosine * cosine) * across;
    const glm::dvec3 beside = glm::normalize(glm::cross(half, random_direction(random)));
    const double from_half = random.between(0.01, 1.57);
    const glm::dvec3 to_light = std::cos(from_half) * half + std::sin(from_half) * beside,
                     to_eye = std::cos(from_half) * half - std::sin(from_half) * beside;
    Lit lit{material, {}, {}, random_vec3(random, 0, 1), cosine};
    const auto access = static_cast<float>(random.between(0, 1));
    lit.point = {kernel_vector(n), kernel_vector(to_eye), {1, 1, 1}, 1, {access, access, access}, 1};
    lit.light.direction = glm::vec3(-to_light);
    lit.light.diffuse = random_vec3(random, 0, 3);
    return lit;
}

// Shininess over its whole range; reflectances bright, dark, very dark, or zero in a channel.
Material random_material(RandomSequence& random) {
    Material material;
    const double brightness = random.whole(0, 1) == 0 ? 1 : std::exp2(random.between(-149, 0));
    material.diffuse = random_vec3(random, 0.1 * brightness, brightness);
    if (random.whole(0, 9) == 0) material.diffuse[random.whole(0, 2)] = 0;
    material.specular = random.whole(0, 1) == 0 ? random_vec3(random, 0, 1) : glm::vec3(1);
    const int kind = random.whole(0, 3);
    material.shininess = static_cast<float>(kind == 0   ? random.whole(0, 2)
                                            : kind == 1 ? random.between(0, 1)
                                                        : random.between(0, 1000));
    return material;
}

bool same_bits(const Vec3<float>& a, const Vec3<float>& b) {
    return float_bits(a.x) == float_bits(b.x) && float_bits(a.y) == float_bits(b.y) &&
           float_bits(a.z) == float_bits(b.z);
}

}  // namespace

TEST_CASE(
    "invisible highlight: left out or not, random materials, normals, eyes and lights give the same bits") {
    int left_out = 0;
    for (std::uint64_t seed = 0; seed < 200000; ++seed) {
        RandomSequence random(seed);
        const Material material = random_material(random);
        const float limit = invisible_highlight(material);
        REQUIRE(limit >= 0);
        REQUIRE(limit < 1);
        // Half of them just below the limit, where the highlight is brightest.
        const double cosine = limit > 0 && seed % 2 == 0 ? limit * (1 - std::exp2(random.between(-22, -3)))
                                                         : random.between(0, 1);
        const Lit lit = lit_at(random, material, cosine);
        INFO("seed " << seed << ", shininess " << material.shininess << ", albedo " << material.diffuse.x
                     << " " << material.diffuse.y << " " << material.diffuse.z << ", cosine " << cosine
                     << ", limit " << limit);
        REQUIRE(same_bits(lit.colour(limit), lit.colour(0)));
        left_out += cosine < static_cast<double>(limit);
    }
    CHECK(left_out > 90000);
}

TEST_CASE("invisible highlight: a limit twice as near to 1 would be seen") {
    int seen = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        RandomSequence random(seed);
        Material material;
        material.diffuse = random_vec3(random, 0.2, 1);
        material.shininess = static_cast<float>(random.between(8, 500));
        const float limit = invisible_highlight(material);
        CAPTURE(material.shininess);
        // At least as wide as the angle outside of which the highlight is a millionth of a millionth.
        CHECK(static_cast<double>(limit) > std::exp2(-40.0 / static_cast<double>(material.shininess)) * 0.99);
        const float raised = 0.5f * (1 + limit);
        const Lit lit = lit_at(random, material, static_cast<double>(raised) * 0.999);
        seen += !same_bits(lit.colour(raised), lit.colour(0));
    }
    CHECK(seen > 1000);
}

TEST_CASE("invisible highlight: nothing is left out where any highlight may be seen") {
    Material material;
    for (const glm::vec3 albedo : {glm::vec3(0), {0, 1, 1}, {1, 1, -1}, {kNan, 1, 1}}) {
        material.diffuse = albedo;
        CHECK(invisible_highlight(material) == 0);
    }
    material.diffuse = glm::vec3(1);
    for (const float shininess : {0.0f, -1.0f, kNan}) {
        material.shininess = shininess;
        CHECK(invisible_highlight(material) == 0);
    }
}
