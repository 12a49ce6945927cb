#include "rasterizer/textures/sample_texture.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

#include <doctest/doctest.h>
#include <glm/vec2.hpp>

#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// What is told by colours is told in these parts, of which all are stored exactly.
constexpr float kPart = 1 / 128.0f;

// Texel (x, y) is red x, green y; its mips are constant and tell their level in blue.
Texture labelled_texture(Size size) {
    Texture texture;
    Image3 base(size, glm::vec3(0));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) base.set(x, y, kPart * glm::vec3(x, y, 0));
    }
    texture.add_level(base);
    for (Size s = size; s.width > 1 || s.height > 1;) {
        s = {std::max(1, s.width / 2), std::max(1, s.height / 2)};
        texture.add_level(Image3(s, kPart * glm::vec3(0, 0, static_cast<float>(texture.levels().size()))));
    }
    return texture;
}

// A texture whose every level is one colour.
Texture constant_texture(Size size, glm::vec3 colour) {
    Texture texture;
    for (Size s = size;; s = {std::max(1, s.width / 2), std::max(1, s.height / 2)}) {
        texture.add_level(Image3(s, colour));
        if (s.width == 1 && s.height == 1) return texture;
    }
}

// The filter that a Sampler without further wishes gives, wrap.
glm::vec3 sample_trilinear(const Texture& texture, glm::vec2 uv, glm::vec2 duv_dx, glm::vec2 duv_dy) {
    return glm::vec3(sample_texture(texture, Sampler{}, uv, duv_dx, duv_dy));
}

// At full size.
glm::vec3 sample_bilinear(const Texture& texture, glm::vec2 uv) {
    return sample_trilinear(texture, uv, glm::vec2(0), glm::vec2(0));
}

float level_at(const Texture& texture, glm::vec2 duv_dx, glm::vec2 duv_dy) {
    return sample_trilinear(texture, glm::vec2(0.5f), duv_dx, duv_dy).z / kPart;
}

}  // namespace

TEST_CASE("texel centres give their texel, and the point between two their mean") {
    const Texture texture = labelled_texture({4, 8});
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 4; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            const glm::vec3 c = sample_bilinear(
                texture, {(static_cast<float>(x) + 0.5f) / 4, (static_cast<float>(y) + 0.5f) / 8});
            CHECK(c == kPart * glm::vec3(x, y, 0));
        }
    }
    CHECK(sample_bilinear(texture, {0.25f, 0.0625f}) == kPart * glm::vec3(0.5f, 0, 0));
    CHECK(sample_bilinear(texture, {0.125f, 0.125f}) == kPart * glm::vec3(0, 0.5f, 0));
    CHECK(sample_bilinear(texture, {0.5f, 0.5f}) == kPart * glm::vec3(1.5f, 3.5f, 0));
    // The picture's edge lies half-way between its last and its first texel.
    for (const float edge : {0.0f, 1.0f, -0.0f, -1.0f, 7.0f, -3.0f}) {
        CAPTURE(edge);
        CHECK(sample_bilinear(texture, {edge, 0.0625f}) == kPart * glm::vec3(1.5f, 0, 0));
    }
}

TEST_CASE("whole repeats change nothing, to the left as to the right") {
    for (const Size size : {Size{1, 1}, {2, 2}, {3, 5}, {5, 3}, {16, 8}}) {
        const Texture texture = labelled_texture(size);
        for (int i = 0; i < 64; ++i) {
            const float u = static_cast<float>(i) / 64;
            for (const int shift : {-1000, -3, -1, 1, 2, 500}) {
                CAPTURE(size.width);
                CAPTURE(u);
                CAPTURE(shift);
                CHECK(sample_bilinear(texture, {u + static_cast<float>(shift), 0.25f}) ==
                      sample_bilinear(texture, {u, 0.25f}));
                CHECK(sample_bilinear(texture, {0.25f, u + static_cast<float>(shift)}) ==
                      sample_bilinear(texture, {0.25f, u}));
            }
        }
    }
}

TEST_CASE("any uv stays within the texture's colours, and what is no position gives the first texels") {
    const float odd[] = {
        -1e-9f, 0,         1 - 0x1p-24f, 1,      1 + 0x1p-23f, -0.0f,        kNan,       1e30f,
        -1e30f, kInfinity, -kInfinity,   1e-45f, 16777215.0f,  -0.99999994f, 0.33333334f};
    for (const int side : {1, 2, 3, 5, 100}) {
        const Texture texture = labelled_texture({side, side});
        const glm::vec3 at_zero = sample_bilinear(texture, {0, 0});
        for (const float u : odd) {
            for (const float v : odd) {
                CAPTURE(side);
                CAPTURE(u);
                CAPTURE(v);
                const glm::vec3 c = sample_bilinear(texture, {u, v});
                const float last = kPart * static_cast<float>(side - 1);
                CHECK(c.x >= 0);
                CHECK(c.x <= last);
                CHECK(c.y >= 0);
                CHECK(c.y <= last);
            }
            if (!(absolute(u) < 1e30f)) CHECK(sample_bilinear(texture, {u, u}) == at_zero);
        }
    }
}

TEST_CASE("a constant texture is that constant everywhere, at every level") {
    const glm::vec3 colour(0.1f, 0.7f, 1 / 3.0f);  // whole numbers of units
    for (const Size size : {Size{1, 1}, {3, 5}, {64, 16}}) {
        const Texture texture = constant_texture(size, colour);
        for (int i = 0; i < 400; ++i) {
            const float a = static_cast<float>(i);
            const glm::vec2 uv(0.37f * a - 50, 0.011f * a), step(0.0003f * a * a, -0.001f * a);
            CAPTURE(i);
            CHECK(sample_trilinear(texture, uv, step, {step.y, 0}) == colour);
        }
        CHECK(sample_trilinear(texture, {kNan, 0.5f}, {kNan, kInfinity}, {0, kNan}) == colour);
    }
}

TEST_CASE("the mip level is that whose texels are as wide as the longer step") {
    const Texture texture = labelled_texture({256, 256});
    REQUIRE(texture.levels().size() == 9);
    for (int level = 0; level < 9; ++level) {
        CAPTURE(level);
        const float step = static_cast<float>(1 << level) / 256;  // uv from one pixel to the next
        CHECK(level_at(texture, {step, 0}, {0, 0}) == static_cast<float>(level));
        CHECK(level_at(texture, {0, 0}, {0, -step}) == static_cast<float>(level));
        CHECK(level_at(texture, {step, 0}, {0, step / 4}) == static_cast<float>(level));
        // Half-way in the logarithm: a blend of both in equal parts.
        if (level > 0 && level < 8) {
            const float between = level_at(texture, {step * 1.41421356f, 0}, {0, 0});
            CHECK(absolute(between - (static_cast<float>(level) + 0.5f)) < 1e-5f);
        }
        // Diagonal steps count by their length.
        const float diagonal = level_at(texture, {step * 0.6f, step * 0.8f}, {0, 0});
        CHECK(absolute(diagonal - static_cast<float>(level)) < 1e-5f);
    }
}

TEST_CASE("steps below a texel take the full size, huge ones the last level, and no number the full size") {
    const Texture texture = labelled_texture({256, 256});
    for (const float tiny : {0.0f, 1e-30f, 0.5f / 256, -0.99f / 256})
        CHECK(level_at(texture, {tiny, 0}, {0, tiny}) == 0);
    for (const float huge : {1.0f, 2.0f, 1e10f, 1e30f, kInfinity})
        CHECK(level_at(texture, {huge, 0}, {0, 0}) == 8);
    CHECK(level_at(texture, {0, 0}, {0, kNan}) == 0);
    CHECK(level_at(texture, {kNan, kNan}, {0, 0}) == 0);
}

TEST_CASE("steps count in texels of each axis") {
    // 64 wide and 16 high: a step of 1/16 of the picture is four texels across and one down.
    const Texture texture = labelled_texture({64, 16});
    CHECK(level_at(texture, {1 / 16.0f, 0}, {0, 0}) == 2);
    CHECK(level_at(texture, {0, 0}, {0, 1 / 16.0f}) == 0);
}
