#include "rasterizer/textures/tga.h"

#include <doctest/doctest.h>
#include <array>

#include "rasterizer/base/error.h"
#include "rasterizer/textures/image_file.h"
#include "tests/tools/picture_files.h"

using namespace crevice;
using namespace std::string_literals;

namespace {

using FileTexel = std::array<int, 4>;

FileTexel pixel(const RgbaPixels& pixels, int x, int y) {
    const auto at = static_cast<std::size_t>((y * pixels.size.width + x) * 4);
    return {pixels.bytes.at(at), pixels.bytes.at(at + 1), pixels.bytes.at(at + 2), pixels.bytes.at(at + 3)};
}

const FileTexel kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kBlue{0, 0, 255, 255},
    kWhite{255, 255, 255, 255};

}  // namespace

TEST_CASE("tga: the first pixel lies in the corner that the descriptor names") {
    // Stored: red, green / blue, white.
    const std::string stored = "\0\0\xff\0\xff\0\xff\0\0\xff\xff\xff"s;
    struct Row {
        const char* corner;
        int descriptor, red_x, red_y;
    };
    for (const Row& row : {Row{"bottom left", 0x00, 0, 1}, Row{"bottom right", 0x10, 1, 1},
                           Row{"top left", 0x20, 0, 0}, Row{"top right", 0x30, 1, 0}}) {
        CAPTURE(row.corner);
        const RgbaPixels pixels = decode_tga(tga_header(2, {2, 2}, 24, row.descriptor) + stored);
        REQUIRE(pixels.size == Size{2, 2});
        const int other_x = 1 - row.red_x, other_y = 1 - row.red_y;
        CHECK(pixel(pixels, row.red_x, row.red_y) == kRed);
        CHECK(pixel(pixels, other_x, row.red_y) == kGreen);
        CHECK(pixel(pixels, row.red_x, other_y) == kBlue);
        CHECK(pixel(pixels, other_x, other_y) == kWhite);
    }
}

TEST_CASE("tga: a palette begins with the entry that the header says") {
    const std::string palette = "\0\0\xff\0\xff\0\xff\0\0"s;  // red, green, blue
    for (const int first : {0, 1, 7}) {
        CAPTURE(first);
        const std::string indices{static_cast<char>(first + 2), static_cast<char>(first)};
        const std::string header = palette_tga_header(1, {2, 1}, 8, 0x20, first, 3, 24);
        const RgbaPixels pixels = decode_tga(header + palette + indices);
        REQUIRE(pixels.size == Size{2, 1});
        CHECK(pixel(pixels, 0, 0) == kBlue);
        CHECK(pixel(pixels, 1, 0) == kRed);
        const std::string beyond{static_cast<char>(first), static_cast<char>(first + 3)};
        CHECK(decode_tga(header + palette + beyond).bytes.empty());
    }
    // 16-bit indices into 16-bit entries, run-length coded: two of the second, one of the first.
    const RgbaPixels coded = decode_tga(palette_tga_header(9, {3, 1}, 16, 0x20, 0, 2, 16) +
                                        "\x00\x7c\xe0\x03"s + "\x81\x01\x00\x00\x00\x00"s);
    REQUIRE(coded.size == Size{3, 1});
    CHECK(pixel(coded, 0, 0) == kGreen);
    CHECK(pixel(coded, 1, 0) == kGreen);
    CHECK(pixel(coded, 2, 0) == kRed);
}

TEST_CASE("tga: every depth, plain and run-length coded") {
    struct Row {
        const char* what;
        int type, bits, descriptor;
        std::string pixels;  // two
        FileTexel first, second;
    };
    const std::vector<Row> rows = {
        {"15 bits", 2, 15, 0x20, "\x00\x7c\xff\x7f"s, kRed, kWhite},
        {"16 bits, no alpha counted", 2, 16, 0x20, "\x00\x7c\x1f\x00"s, kRed, kBlue},
        {"16 bits, one of alpha", 2, 16, 0x21, "\x00\xfc\x1f\x00"s, kRed, {0, 0, 255, 0}},
        {"24 bits", 2, 24, 0x20, "\x03\x02\x01\xff\0\0"s, {1, 2, 3, 255}, kBlue},
        {"32 bits, no alpha counted", 2, 32, 0x20, "\x03\x02\x01\0\xff\0\0\0"s, {1, 2, 3, 255}, kBlue},
        {"32 bits, eight of alpha", 2, 32, 0x28, "\x03\x02\x01\x04\xff\0\0\xff"s, {1, 2, 3, 4}, kBlue},
        {"grey", 3, 8, 0x20, "\x07\xff"s, {7, 7, 7, 255}, kWhite},
        {"grey and alpha", 3, 16, 0x28, "\x07\x80\xff\xff"s, {7, 7, 7, 128}, kWhite},
        {"coded, a raw packet", 10, 24, 0x20, "\x01\x03\x02\x01\xff\0\0"s, {1, 2, 3, 255}, kBlue},
        {"coded, two packets", 10, 24, 0x20, "\x80\x03\x02\x01\x80\xff\0\0"s, {1, 2, 3, 255}, kBlue},
        {"coded, a run beyond the last pixel", 11, 8, 0x20, "\xff\x07"s, {7, 7, 7, 255}, {7, 7, 7, 255}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const std::string file = tga_header(row.type, {2, 1}, row.bits, row.descriptor) + row.pixels;
        CHECK(tga_header(file).valid);
        const RgbaPixels pixels = decode_tga(file);
        REQUIRE(pixels.size == Size{2, 1});
        CHECK(pixel(pixels, 0, 0) == row.first);
        CHECK(pixel(pixels, 1, 0) == row.second);
        for (std::size_t length = 18; length < file.size(); ++length) {
            CAPTURE(length);
            CHECK(decode_tga(file.substr(0, length)).bytes.empty());
        }
    }
}

TEST_CASE("tga: a header that is not believable is none") {
    const std::string good = tga_header(2, {1, 1}, 24, 0x20);
    CHECK(tga_header(good).valid);
    struct Row {
        std::size_t at;
        int value;
    };
    for (const Row& row :
         {Row{1, 2}, Row{2, 0}, Row{2, 4}, Row{2, 32}, Row{16, 8}, Row{16, 12}, Row{17, 0x40}}) {
        CAPTURE(row.at);
        CAPTURE(row.value);
        std::string bad = good;
        bad[row.at] = static_cast<char>(row.value);
        CHECK_FALSE(tga_header(bad).valid);
    }
    CHECK_FALSE(tga_header(good.substr(0, 17)).valid);
}

TEST_CASE("tga: a large size without the bytes for it is refused, not allocated") {
    CHECK(decode_tga(tga_header(2, {16384, 4096}, 32, 0x20).append("1234")).bytes.empty());
    CHECK(decode_tga(tga_header(10, {16384, 4096}, 32, 0x20).append("\xff\1\2\3\4")).bytes.empty());
    CHECK_THROWS_WITH_AS(decode_image(tga_header(2, {16384, 16384}, 8, 0x20), "a.tga", TextureEncoding::srgb),
                         doctest::Contains("not a PNG, JPEG or TGA"), InputError);
    CHECK_THROWS_WITH_AS(decode_image(tga_header(3, {16384, 16384}, 8, 0x20), "a.tga", TextureEncoding::srgb),
                         doctest::Contains("out of range (16384 x 16384)"), InputError);
}
