// Alpha and data textures: build_texture and load_texture beyond colours.
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/textures/texture.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

// 2 x 1 RGBA: (255, 0, 128, 255) and (10, 20, 30, 64).
constexpr std::array<unsigned char, 77> kPngWithAlpha = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52,
    0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00, 0x00, 0xf4, 0x22, 0x7f,
    0x8a, 0x00, 0x00, 0x00, 0x14, 0x49, 0x44, 0x41, 0x54, 0x78, 0x01, 0x01, 0x09, 0x00, 0xf6, 0xff,
    0x00, 0xff, 0x00, 0x80, 0xff, 0x0a, 0x14, 0x1e, 0x40, 0x10, 0xdc, 0x02, 0xfb, 0xcb, 0x71, 0xdd,
    0x11, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

Texture loaded(const std::string& bytes, TextureEncoding encoding = TextureEncoding::srgb) {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "picture", std::ios::binary) << bytes;
    return load_texture(scratch / "picture", encoding);
}

// 2 x 1 TGA of 32-bit pixels whose header counts `alpha_bits`.
std::string tga(int alpha_bits, unsigned char first_alpha, unsigned char second_alpha) {
    std::string bytes(18, '\0');
    bytes[2] = 2;
    bytes[12] = 2;
    bytes[14] = 1;
    bytes[16] = 32;
    bytes[17] = static_cast<char>(0x20 | alpha_bits);
    for (const unsigned char alpha : {first_alpha, second_alpha})
        bytes += std::string("\x40\x80\xff", 3) + static_cast<char>(alpha);
    return bytes;
}

}  // namespace

TEST_CASE("load_texture: PNG with alpha, which is linear while colours are sRGB") {
    const Texture texture = loaded({kPngWithAlpha.begin(), kPngWithAlpha.end()});
    REQUIRE(texture.levels().size() == 2);
    CHECK(texture.alpha(0).at(0, 0) == 1);
    CHECK(texture.alpha(0).at(1, 0) == 64.0f / 255);
    CHECK(texture.alpha(1).at(0, 0) == 0.5f * (1 + 64.0f / 255));
    CHECK(std::abs(texture.colour(0).at(1, 0).x - linear_from_srgb(10.0f / 255)) <= kTexelError);
    CHECK(texture.colour(0).at(0, 0).x == 1);
}

TEST_CASE("load_texture: data is code / 255") {
    const Texture texture = loaded({kPngWithAlpha.begin(), kPngWithAlpha.end()}, TextureEncoding::linear);
    CHECK(texture.colour(0).at(0, 0) == glm::vec3(1, 0, 128.0f / 255));
    CHECK(texture.colour(0).at(1, 0) == glm::vec3(10, 20, 30) / 255.0f);
    CHECK(texture.alpha(0).at(1, 0) == 64.0f / 255);
}

TEST_CASE("load_texture: TGA has alpha where its header says so, and not where all of it is 1") {
    const Texture with_alpha = loaded(tga(8, 255, 51));
    REQUIRE(with_alpha.has_alpha());
    CHECK(with_alpha.alpha(0).at(1, 0) == 0.2f);
    CHECK(with_alpha.colour(0).at(1, 0).x == 1);
    CHECK(!loaded(tga(0, 0, 0)).has_alpha());
    CHECK(!loaded(tga(8, 255, 255)).has_alpha());
    CHECK(loaded(tga(8, 0, 0)).has_alpha());
}

TEST_CASE("build_texture: alpha has a level for each of the colours, with the same mean") {
    for (const Size size : {Size{1, 1}, {8, 8}, {5, 3}, {1, 7}, {100, 1}}) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        Image3 base(size, glm::vec3(0));
        Image<float> alpha(size, 0);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const float value = static_cast<float>((x * 37 + y * 11) % 16) / 16;
                base.set(x, y, glm::vec3(value, 0, 0));
                alpha.at(x, y) = value;
            }
        }
        const Texture texture = build_texture(base, alpha);
        REQUIRE(texture.has_alpha());
        for (std::size_t level = 0; level < texture.levels().size(); ++level) {
            CAPTURE(level);
            CHECK(texture.alpha(level).size == texture.colour(level).size());
            for (int x = 0; x < texture.alpha(level).size.width; ++x)
                CHECK(texture.alpha(level).at(x, 0) == texture.colour(level).x.at(x, 0));
        }
        CHECK(!build_texture(base).has_alpha());
    }
    CHECK_THROWS_WITH_AS(build_texture(Image3({4, 4}, glm::vec3(0)), Image<float>({4, 3}, 1.0f)),
                         doctest::Contains("4 x 3, not 4 x 4"), UsageError);
}
