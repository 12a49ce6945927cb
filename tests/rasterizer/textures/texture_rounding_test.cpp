// What is lost by storing a texel in 16 bits a channel: at most half a unit through every filter, address mode and
// size, against the same filter over floats.
#include <cmath>
#include <cstdint>

#include <doctest/doctest.h>
#include <glm/common.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/textures/cutout_mips.h"
#include "rasterizer/textures/sample_texture.h"
#include "tests/tools/float_texture.h"
#include "tests/tools/largest_tie.h"
#include "tests/tools/plain_texture_filter.h"

using namespace crevice;

namespace {

// Of what a filter makes of stored values: their error, and what floats round beside.
constexpr float kLimit = kTexelError + 0x1p-22f;
static_assert(kLimit < 0x1p-16f);

struct Numbers {
    std::uint32_t state = 1;
    float unit() {
        state = state * 1664525u + 1013904223u;
        return static_cast<float>(state >> 8) / 16777216.0f;
    }
    float between(float low, float high) { return low + unit() * (high - low); }
};

struct Planes {
    Image3 colour;
    Image<float> alpha;
};

Planes random_planes(Size size, std::uint32_t seed) {
    Numbers random{seed};
    Planes planes{Image3(size, glm::vec3(0)), Image<float>(size, 0.0f)};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            planes.colour.set(x, y, {random.unit(), random.unit(), random.unit()});
            planes.alpha.at(x, y) = random.unit();
        }
    }
    return planes;
}

}  // namespace

TEST_CASE(
    "texture rounding: codes of 8 bits, 256ths and what is opaque are stored exactly, sRGB to half a unit") {
    Image3 base({256, 1}, glm::vec3(0));
    for (int code = 0; code < 256; ++code) {
        const float part = static_cast<float>(code) / 255;
        base.set(code, 0, {part, static_cast<float>(code) / 256, linear_from_srgb(part)});
    }
    const Texture texture = build_texture(base);
    for (int code = 0; code < 256; ++code) {
        CAPTURE(code);
        const glm::vec4 stored = texture.texel(0, code, 0);
        CHECK(stored.x == base.x.at(code, 0));
        CHECK(stored.y == base.y.at(code, 0));
        CHECK(std::abs(stored.z - base.z.at(code, 0)) <= kTexelError);
        CHECK(stored.w == 1);
    }
    CHECK(texture.texel(0, 255, 0).x == 1);
}

TEST_CASE("texture rounding: what is out of range is clamped, and NaN counts as 0") {
    Image3 base({3, 1}, glm::vec3(0));
    base.set(0, 0, {-1, 2, std::nanf("")});
    base.set(1, 0, {-INFINITY, INFINITY, 1.00001f});
    const Texture texture = build_texture(base);
    CHECK(glm::vec3(texture.texel(0, 0, 0)) == glm::vec3(0, 1, 0));
    CHECK(glm::vec3(texture.texel(0, 1, 0)) == glm::vec3(0, 1, 1));
}

TEST_CASE(
    "texture rounding: every filter, address mode, anisotropy and size is as near to floats as a texel is") {
    Numbers random;
    float largest = 0;
    for (const Size size : {Size{1, 1}, {1, 7}, {9, 1}, {5, 3}, {16, 16}, {33, 17}, {64, 64}}) {
        const Planes planes = random_planes(size, 7);
        const Texture stored = build_texture(planes.colour, planes.alpha);
        const FloatTexture floats(planes.colour, planes.alpha);
        REQUIRE(floats.level_count() == stored.levels().size());
        for (const TextureFilter filter : {TextureFilter::point, TextureFilter::bilinear,
                                           TextureFilter::trilinear, TextureFilter::anisotropic}) {
            for (const AddressMode u : {AddressMode::wrap, AddressMode::clamp, AddressMode::border}) {
                for (const AddressMode v : {AddressMode::wrap, AddressMode::clamp, AddressMode::border}) {
                    for (int i = 0; i < 60; ++i) {
                        const Sampler sampler{filter, 1 + i % 16, u, v, {0.3f, 0.6f, 0.123f, 0.77f}};
                        const float step = std::ldexp(1.0f, -i % 9);
                        const glm::vec2 uv(random.between(-1.5f, 2.5f), random.between(-1.5f, 2.5f)),
                            dx(random.between(-step, step), random.between(-step, step)),
                            dy(random.between(-0.1f, 0.1f), random.between(-step, step));
                        const glm::vec4 seen = sample_texture(stored, sampler, uv, dx, dy),
                                        expected = plain_filter(floats, sampler, uv, dx, dy),
                                        off = glm::abs(seen - expected);
                        for (int c = 0; c < 4; ++c) {
                            largest = std::max(largest, off[c]);
                            if (off[c] <= kLimit) continue;
                            INFO(size.width, " x ", size.height, ", filter ", static_cast<int>(filter),
                                 ", address ", static_cast<int>(u), " ", static_cast<int>(v), ", uv ", uv.x,
                                 " ", uv.y, ", channel ", c);
                            CHECK(seen[c] == expected[c]);
                        }
                    }
                }
            }
        }
    }
    CHECK(largest > 0.1f / kTexelOne);  // the two are not the same thing
}

TEST_CASE("texture rounding: no texel of a cut-out is carried over the threshold") {
    for (const float threshold : {0.1f, 0.1f + 0x1p-18f, 1 / 3.0f, 0.5f, 0.9f, 1.0f}) {
        CAPTURE(threshold);
        for (std::uint32_t seed = 1; seed <= 5; ++seed) {
            // Values so near each other that scaling would make one of many.
            Planes planes = random_planes({64, 64}, seed);
            for (float& value : planes.alpha.pixels) value = value < 0.5f ? 0.9f + 0.001f * value : 0.0f;
            const Texture plain = build_texture(planes.colour, planes.alpha);
            const Texture kept = keep_coverage(plain, threshold);
            const double wanted = coverage(plain.alpha(0), threshold);
            CHECK(coverage(kept.alpha(0), threshold) == wanted);
            for (std::size_t level = 1; level < kept.levels().size(); ++level) {
                CHECK(std::abs(coverage(kept.alpha(level), threshold) - wanted) <=
                      coverage_slack(plain.alpha(level)));
            }
        }
    }
}
