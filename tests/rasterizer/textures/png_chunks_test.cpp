// What chunks say counts: the exponent of colours, and a palette that lacks some.
#include "rasterizer/textures/png_chunks.h"

#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/textures/image_file.h"
#include "tests/tools/picture_files.h"

using namespace crevice;
using namespace std::string_literals;

namespace {

std::string gamma_chunk(std::uint32_t hundred_thousandths) {
    return png_chunk("gAMA", big_endian_bytes(hundred_thousandths, 4));
}

std::string grey_with(const std::string& chunks) {
    return png_file({1, 1}, {.colour_type = 0, .chunks = chunks}, "\x80"s);
}

std::string indexed(int bits, const std::string& pixels, const std::string& chunks) {
    return png_file({4, 1}, {.colour_type = 3, .bits = bits, .chunks = chunks}, pixels);
}

}  // namespace

TEST_CASE("png_gamma: the exponent of colours, nothing where they are sRGB") {
    CHECK(png_gamma(grey_with(gamma_chunk(100000))) == 1.0f);
    CHECK(png_gamma(grey_with(gamma_chunk(55556))) == 0.55556f);
    const std::vector<std::string> srgb = {{},
                                           gamma_chunk(45455),
                                           gamma_chunk(45000),
                                           gamma_chunk(47000),
                                           gamma_chunk(0),
                                           gamma_chunk(9999),
                                           gamma_chunk(~0u),
                                           png_chunk("gAMA", "\0"s),
                                           png_chunk("sRGB", "\0"s) + gamma_chunk(100000),
                                           gamma_chunk(100000) + png_chunk("iCCP", "name\0\0"s),
                                           png_chunk("tEXt", "gAMA"s + big_endian_bytes(100000, 4))};
    for (const std::string& chunks : srgb) CHECK_FALSE(png_gamma(grey_with(chunks)));
    for (const std::string& file : {""s, grey_jpeg(), grey_with(gamma_chunk(100000)).substr(0, 40)})
        CHECK_FALSE(png_gamma(file));
}

TEST_CASE("decode_image: light is a colour's code to the power of 1 / gamma; data are left alone") {
    for (const std::uint32_t gamma : {100000u, 55556u, 35000u, 200000u}) {
        const std::string file = grey_with(gamma_chunk(gamma));
        const double light = std::pow(128.0 / 255, 1e5 / gamma);
        CHECK(decode_image(file, "a.png", TextureEncoding::srgb).colour.at(0, 0).x ==
              doctest::Approx(light).epsilon(1e-5));
        CHECK(decode_image(file, "a.png", TextureEncoding::linear).colour.at(0, 0).x == 128.0f / 255);
    }
}

TEST_CASE("decode_image: a pixel whose colour the palette lacks is damage") {
    struct Row {
        int bits;
        std::string right, wrong;  // four pixels: 0 1 2 0 and 0 1 3 0
    };
    const std::vector<Row> rows = {
        {8, "\0\1\2\0"s, "\0\1\3\0"s}, {4, "\x01\x20"s, "\x01\x30"s}, {2, "\x18"s, "\x1c"s}};
    const std::string palette = png_chunk("PLTE", "\xff\0\0\0\xff\0\0\0\xff"s);
    for (const Row& row : rows) {
        for (const std::string& alphas : {""s, "\xff"s, "\0\1"s, "\0\xff\xfe"s}) {
            CAPTURE(row.bits);
            const std::string chunks = palette + (alphas.empty() ? "" : png_chunk("tRNS", alphas));
            const DecodedImage image =
                decode_image(indexed(row.bits, row.right, chunks), "a.png", TextureEncoding::linear);
            for (int x = 0; x < 3; ++x) {
                glm::vec3 colour(0);
                colour[x] = 1;
                CHECK(image.colour.at(x, 0) == colour);
                const auto at = static_cast<std::size_t>(x);
                const float alpha = at < alphas.size() ? static_cast<unsigned char>(alphas[at]) / 255.0f : 1;
                CHECK((image.alpha.empty() ? 1.0f : image.alpha.at(x, 0)) == alpha);
            }
            CHECK_THROWS_WITH_AS(
                decode_image(indexed(row.bits, row.wrong, chunks), "a.png", TextureEncoding::linear),
                doctest::Contains(
                    "a.png: the picture is damaged (PNG, a pixel whose colour the palette lacks)"),
                InputError);
        }
    }
}

TEST_CASE("with_whole_palette: nothing where every number has a colour, or where chunks are not in order") {
    const std::string four = png_chunk("PLTE", std::string(12, '\1')),
                      two = png_chunk("PLTE", std::string(6, '\1'));
    CHECK_FALSE(with_whole_palette(indexed(2, "\x1b"s, four)));
    CHECK_FALSE(with_whole_palette(indexed(2, "\x1b"s, {})));
    CHECK_FALSE(with_whole_palette(indexed(2, "\x1b"s, png_chunk("tRNS", "\1"s) + two)));
    CHECK_FALSE(with_whole_palette(indexed(2, "\x1b"s, two + png_chunk("tRNS", "\1\1\1"s))));
    CHECK_FALSE(with_whole_palette(indexed(2, "\x1b"s, png_chunk("PLTE", "\1\1"s))));
    CHECK_FALSE(with_whole_palette(grey_with(two)));
    CHECK(with_whole_palette(indexed(2, "\x1b"s, two)));
    CHECK(with_whole_palette(indexed(2, "\x1b"s, two))->alpha == 0);
    CHECK(with_whole_palette(indexed(2, "\x1b"s, two + png_chunk("tRNS", "\0"s)))->alpha == 1);
}
