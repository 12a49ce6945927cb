// Highlights that are left out because they cannot be seen: the bits of a surface lit with and without them.
#include <algorithm>
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

    Vec3<float> colour(InvisibleHighlights invisible) const {
        return blinn_schlick(point, material, {light}, ambient_light, invisible);
    }
    double shininess() const { return static_cast<double>(point.gloss * material.shininess); }
    double albedo() const {
        const Vec3<float> of = point.texture_colour * spread<float>(material.diffuse);
        return static_cast<double>(std::min(of.x, std::min(of.y, of.z)));
    }
    bool leaves_out(InvisibleHighlights invisible) const {
        return shininess() * (1 - cosine) > static_cast<double>(invisible.falloff) &&
               albedo() >= static_cast<double>(invisible.albedo);
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

// A texture that is white, or has anything from just below `darkest` to white in it, and a gloss below 1.
void cover(RandomSequence& random, Lit& lit, double darkest) {
    if (random.whole(0, 1) == 0) return;
    lit.point.texture_colour = kernel_vector(glm::dvec3(random_vec3(random, 0.9 * darkest, 1.2 * darkest)));
    lit.point.gloss = static_cast<float>(random.between(0, 1));
}

bool same_bits(const Vec3<float>& a, const Vec3<float>& b) {
    return float_bits(a.x) == float_bits(b.x) && float_bits(a.y) == float_bits(b.y) &&
           float_bits(a.z) == float_bits(b.z);
}

}  // namespace

TEST_CASE("invisible highlight: left out or not, random surfaces, eyes and lights give the same bits") {
    int left_out = 0;
    for (std::uint64_t seed = 0; seed < 200000; ++seed) {
        RandomSequence random(seed);
        const Material material = random_material(random);
        const double darkest = std::exp2(random.between(-20, 0));
        const InvisibleHighlights invisible = invisible_highlights(material, static_cast<float>(darkest));
        REQUIRE(invisible.falloff > 0);
        Lit lit = lit_at(random, material, random.between(0, 1));
        cover(random, lit, darkest);
        // Half of them just beyond the limit, where the highlight is brightest.
        const double limit = 1 - static_cast<double>(invisible.falloff) / lit.shininess();
        if (limit > 0 && seed % 2 == 0) {
            const Vec3<float> colour = lit.point.texture_colour;
            const float gloss = lit.point.gloss;
            lit = lit_at(random, material, limit * (1 - std::exp2(random.between(-22, -3))));
            lit.point.texture_colour = colour;
            lit.point.gloss = gloss;
        }
        INFO("seed " << seed << ", shininess " << lit.shininess() << ", albedo " << lit.albedo()
                     << ", cosine " << lit.cosine << ", limit " << limit);
        REQUIRE(same_bits(lit.colour(invisible), lit.colour(kNoInvisibleHighlights)));
        left_out += lit.leaves_out(invisible);
    }
    CHECK(left_out > 40000);
}

TEST_CASE("invisible highlight: half the limit would be seen") {
    int seen = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        RandomSequence random(seed);
        Material material;
        material.diffuse = random_vec3(random, 0.2, 1);
        material.shininess = static_cast<float>(random.between(50, 500));
        const InvisibleHighlights invisible = invisible_highlights(material, 1);
        CAPTURE(material.shininess);
        // No wider than where the highlight is a millionth of a millionth.
        CHECK(invisible.falloff < 28);
        const InvisibleHighlights halved{0.5f * invisible.falloff, invisible.albedo};
        const double cosine = 1 - 1.01 * static_cast<double>(halved.falloff / material.shininess);
        const Lit lit = lit_at(random, material, cosine);
        seen += !same_bits(lit.colour(halved), lit.colour(kNoInvisibleHighlights));
    }
    CHECK(seen > 1000);
}

TEST_CASE("invisible highlight: nothing is left out where any highlight may be seen") {
    const auto none_is = [](const Material& material) {
        return std::isinf(invisible_highlights(material, 1).falloff);
    };
    Material material;
    CHECK_FALSE(none_is(material));
    for (const glm::vec3 albedo : {glm::vec3(0), {0, 1, 1}, {1, 1, -1}, {kNan, 1, 1}}) {
        material.diffuse = albedo;
        CHECK(none_is(material));
    }
    material.diffuse = glm::vec3(1);
    for (const float shininess : {0.0f, -1.0f, kNan}) {
        material.shininess = shininess;
        CHECK(none_is(material));
    }
    material = {};
    material.specular = glm::vec3(1.5f);
    CHECK(none_is(material));
}
