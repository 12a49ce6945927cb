#include "rasterizer/textures/sampler.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/textures/sample_texture.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr AddressMode kModes[] = {AddressMode::wrap, AddressMode::clamp, AddressMode::border};
constexpr TextureFilter kFilters[] = {TextureFilter::point, TextureFilter::bilinear, TextureFilter::trilinear,
                                      TextureFilter::anisotropic};

Sampler sampler_of(TextureFilter filter, AddressMode mode, glm::vec4 border = {0, 0, 0, 1}) {
    return {filter, 8, mode, mode, border};
}

// Texel (x, y) is red (x + 1) / 8, green (y + 1) / 8, with alpha (x + 2) / 8.
Texture labelled_texture(Size size) {
    Image3 base(size, glm::vec3(0));
    Image<float> alpha(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            base.set(x, y, glm::vec3(x + 1, y + 1, 0) / 8.0f);
            alpha.at(x, y) = static_cast<float>(x + 2) / 8;
        }
    }
    return build_texture(base, alpha);
}

// At full size.
glm::vec4 sample(const Texture& texture, const Sampler& sampler, glm::vec2 uv) {
    return sample_texture(texture, sampler, uv, glm::vec2(0), glm::vec2(0));
}

float centre_of(int texel, int count) {
    return (static_cast<float>(texel) + 0.5f) / static_cast<float>(count);
}

// Levels of one colour each: blue and alpha tell the level, in sixteenths.
Texture level_texture(int side) {
    Texture texture;
    for (; side >= 1; side /= 2) {
        const float level = static_cast<float>(texture.levels().size());
        texture.add_level(Image3({side, side}, glm::vec3(0, 0, level / 16)),
                          Image<float>({side, side}, level / 16));
    }
    return texture;
}

}  // namespace

TEST_CASE("sampler: texels far outside are those of the address mode, also to the left") {
    for (const int count : {1, 2, 3, 5}) {
        const Texture texture = labelled_texture({count, count});
        for (int i = -20; i <= 20; ++i) {
            CAPTURE(count);
            CAPTURE(i);
            const int wrapped = (i % count + count) % count, clamped = std::clamp(i, 0, count - 1);
            for (const TextureFilter filter : {TextureFilter::point, TextureFilter::bilinear}) {
                const glm::vec2 uv(centre_of(i, count), centre_of(0, count));
                const auto red = [&](AddressMode mode) {
                    return 8 * sample(texture, sampler_of(filter, mode, glm::vec4(0.5f)), uv).x - 1;
                };
                CHECK(std::abs(red(AddressMode::wrap) - static_cast<float>(wrapped)) < 1e-5f);
                CHECK(std::abs(red(AddressMode::clamp) - static_cast<float>(clamped)) < 1e-5f);
                CHECK(std::abs(red(AddressMode::border) - (i == clamped ? static_cast<float>(i) : 3.0f)) <
                      1e-5f);
            }
        }
    }
}

TEST_CASE("sampler: axes have an address mode each") {
    const Texture texture = labelled_texture({4, 4});
    Sampler sampler = sampler_of(TextureFilter::point, AddressMode::wrap);
    sampler.address_v = AddressMode::clamp;
    CHECK(sample(texture, sampler, {1.1f, 1.1f}) == glm::vec4(0.125f, 0.5f, 0, 0.25f));
    std::swap(sampler.address_u, sampler.address_v);
    CHECK(sample(texture, sampler, {1.1f, 1.1f}) == glm::vec4(0.5f, 0.125f, 0, 0.625f));
}

TEST_CASE("sampler: the border is half-way at the edge, whole half a texel outside, alpha included") {
    const glm::vec4 border(1, 0, 0.5f, 0.25f), first(0.125f, 0.125f, 0, 0.25f);
    const Sampler sampler = sampler_of(TextureFilter::bilinear, AddressMode::border, border);
    const Texture texture = labelled_texture({4, 4});
    const float v = centre_of(0, 4);
    CHECK(sample(texture, sampler, {0.125f, v}) == first);
    CHECK(sample(texture, sampler, {0, v}) == 0.5f * (first + border));
    CHECK(sample(texture, sampler, {-0.125f, v}) == border);
    CHECK(sample(texture, sampler, {1.125f, v}) == border);
    CHECK(sample(texture, sampler, {0.5f, 1.125f}) == border);
    CHECK(sample(texture, sampler, {0, 0}) == 0.25f * first + 0.75f * border);
    const Texture opaque = build_texture(texture.colour(0));
    CHECK(sample(opaque, sampler, {0.125f, v}).w == 1);
    CHECK(sample(opaque, sampler, {0, v}).w == 0.625f);
}

TEST_CASE("sampler: clamp repeats the edge texels exactly") {
    const Texture texture = labelled_texture({3, 5});
    const Sampler sampler = sampler_of(TextureFilter::trilinear, AddressMode::clamp);
    for (const float outside : {0.0f, -0.0f, -0.1f, -7.0f, -1e30f, -kInfinity}) {
        CAPTURE(outside);
        CHECK(sample(texture, sampler, {outside, 0.5f}).x == 0.125f);
        CHECK(sample(texture, sampler, {1 - outside, 0.5f}).x == 0.375f);
        CHECK(sample(texture, sampler, {0.5f, 1 - outside}).y == 0.625f);
    }
}

TEST_CASE("sampler: any coordinates and steps give a value between the smallest and the largest") {
    const float odd[] = {-1e-9f, 0,      0.17f,     1 - 0x1p-24f, 1,     1 + 0x1p-23f, -0.0f, kNan,
                         1e30f,  -1e30f, kInfinity, -kInfinity,   0.34f, -0.99999994f, 3e38f};
    for (const int side : {1, 2, 3, 5}) {
        const Texture texture = labelled_texture({side, side});
        const float largest = static_cast<float>(side + 1) / 8 + 1e-6f;
        for (const TextureFilter filter : kFilters) {
            for (const AddressMode mode : kModes) {
                const Sampler sampler = sampler_of(filter, mode, glm::vec4(0.125f));
                for (const float u : odd) {
                    for (const float v : odd) {
                        for (const glm::vec2 step : {glm::vec2(0), {0.3f, 0}, {u, v}}) {
                            CAPTURE(side);
                            CAPTURE(static_cast<int>(filter));
                            CAPTURE(static_cast<int>(mode));
                            CAPTURE(u);
                            CAPTURE(v);
                            const glm::vec4 c = sample_texture(texture, sampler, {u, v}, step, {v, 0.7f});
                            for (const int k : {0, 1, 3}) {
                                CHECK(c[k] >= 0.125f - 1e-6f);
                                CHECK(c[k] <= largest);
                            }
                        }
                    }
                }
                CHECK(sample(texture, sampler, {kNan, kNan}) == sample(texture, sampler, {0, 0}));
            }
        }
    }
}

TEST_CASE("sampler: a constant texture is that constant through every filter") {
    const glm::vec4 colour(0.1f, 0.7f, 1 / 3.0f, 0.9f);  // whole numbers of units
    for (const Size size : {Size{1, 1}, {3, 5}, {64, 16}}) {
        Texture texture;
        const Texture chain = build_texture(Image3(size, glm::vec3(0)));
        for (const Texture::Level& level : chain.levels()) {
            texture.add_level(Image3(level.size, glm::vec3(colour)), Image<float>(level.size, colour.w));
        }
        for (const TextureFilter filter : kFilters) {
            for (const AddressMode mode : kModes) {
                for (int i = 0; i < 100; ++i) {
                    const float a = static_cast<float>(i);
                    CAPTURE(i);
                    CAPTURE(static_cast<int>(filter));
                    CAPTURE(static_cast<int>(mode));
                    const glm::vec2 uv(0.037f * a - 1, 0.011f * a), step(0.0003f * a * a, -0.001f * a);
                    CHECK(sample_texture(texture, sampler_of(filter, mode, colour), uv, step,
                                         {step.y, 0.1f * step.x}) == colour);
                }
            }
        }
    }
}

TEST_CASE("sampler: point and bilinear take the nearest mip level, trilinear both") {
    const Texture texture = level_texture(256);
    for (const float level : {0.0f, 0.4f, 0.6f, 1.0f, 2.4f, 2.6f, 7.6f, 9.0f}) {
        CAPTURE(level);
        const float step = std::exp2(level) / 256;
        const auto blue = [&](TextureFilter filter) {
            const glm::vec4 c = sample_texture(texture, sampler_of(filter, AddressMode::wrap),
                                               glm::vec2(0.3f), {step, 0}, {0, step / 2});
            CHECK(c.w == c.z);
            return 16 * c.z;
        };
        const float nearest = std::min(8.0f, std::floor(level + 0.5f));
        CHECK(blue(TextureFilter::point) == nearest);
        CHECK(blue(TextureFilter::bilinear) == nearest);
        CHECK(std::abs(blue(TextureFilter::trilinear) - std::min(8.0f, level)) < 1e-5f);
        // The shorter step counts, half of the longer: one level finer.
        CHECK(std::abs(blue(TextureFilter::anisotropic) - std::clamp(level - 1, 0.0f, 8.0f)) < 1e-5f);
    }
}

TEST_CASE("sampler: what is out of range is named") {
    CHECK_NOTHROW(validate(Sampler{}));
    for (const int probes : {0, -1, 17}) {
        Sampler sampler;
        sampler.max_anisotropy = probes;
        CAPTURE(probes);
        CHECK_THROWS_WITH_AS(validate(sampler), doctest::Contains("max_anisotropy"), UsageError);
    }
    for (const float value : {-0.1f, 1.1f, kNan}) {
        Sampler sampler;
        sampler.border.w = value;
        CAPTURE(value);
        CHECK_THROWS_WITH_AS(validate(sampler), doctest::Contains("border"), UsageError);
    }
}
