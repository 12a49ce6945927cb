// TIFFs put together by hand are read as the format says; what cannot be read is named.
#include "chapters/images/tiff.h"

#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/error_message.h"
#include "tests/tools/tiff_by_hand.h"

using namespace crevice;

namespace {

// 20 x 2 pixels of 8 bits in two tiles of 16 x 16 side by side; pixel (x, y) is x + 20 y, all around it 255.
std::string tiled_by_hand() {
    constexpr std::uint32_t kWidth = 20, kHeight = 2, kTile = 16, kTileBytes = kTile * kTile;
    const std::vector<TiffTag> tags = {{256, kWidth}, {257, kHeight}, {258, 8},     {259, 1}, {262, 1},
                                       {277, 1},      {322, kTile},   {323, kTile}, {324, 0}, {325, 0}};
    const std::uint32_t arrays = 8 + 2 + 12 * static_cast<std::uint32_t>(tags.size()) + 4,
                        pixels = arrays + 16;
    std::string file = std::string("II*\0", 4) + bytes_of_number(std::uint32_t{8}) +
                       bytes_of_number(static_cast<std::uint16_t>(tags.size()));
    for (const TiffTag& tag : tags) {
        const bool array = tag.tag == 324 || tag.tag == 325;
        const std::uint32_t place = tag.tag == 324 ? arrays : arrays + 8;
        file += bytes_of_number(tag.tag) + bytes_of_number(std::uint16_t{4}) +
                bytes_of_number(array ? 2u : 1u) + bytes_of_number(array ? place : tag.value);
    }
    file += bytes_of_number(std::uint32_t{0}) + bytes_of_number(pixels) +
            bytes_of_number(pixels + kTileBytes) + bytes_of_number(kTileBytes) + bytes_of_number(kTileBytes);
    for (std::uint32_t left = 0; left < kWidth; left += kTile) {
        for (std::uint32_t i = 0; i < kTileBytes; ++i) {
            const std::uint32_t x = left + i % kTile, y = i / kTile;
            file += static_cast<char>(x < kWidth && y < kHeight ? x + kWidth * y : 255);
        }
    }
    return file;
}

// Empty where the program was built without libtiff.
std::vector<TiffImage> read(const std::string& bytes) {
    try {
        return {tiff_image(bytes, "a.tif")};
    } catch (const UsageError& error) {
        CHECK(contains(error.what(), "built without libtiff; install libtiff-dev"));
        MESSAGE("built without libtiff");
        return {};
    }
}

std::string refusal(const std::string& bytes) {
    try {
        tiff_image(bytes, "a.tif");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

constexpr std::uint32_t kWhole = 1, kReal = 3;

}  // namespace

TEST_CASE("tiff: codes of 8 and 16 bits, floats, grey and RGB, alpha") {
    const std::string bytes("\x00\x33\xff\x66", 4);
    for (const TiffImage& grey : read(tiff_by_hand(2, 2, 8, 1, kWhole, bytes))) {
        REQUIRE(grey.planes.size() == 1);
        CHECK(grey.planes[0].at(1, 0) == 51.0f / 255);
        CHECK(grey.planes[0].at(0, 1) == 1);
        CHECK(!grey.linear);
        CHECK(grey.alpha.empty());
    }
    const std::string words = bytes_of_number(std::uint16_t{1}) + bytes_of_number(std::uint16_t{65535}) +
                              bytes_of_number(std::uint16_t{256});
    for (const TiffImage& colour : read(tiff_by_hand(1, 1, 16, 3, kWhole, words))) {
        REQUIRE(colour.planes.size() == 3);
        CHECK(colour.planes[0].at(0, 0) == 1.0f / 65535);
        CHECK(colour.planes[1].at(0, 0) == 1);
        CHECK(colour.planes[2].at(0, 0) == 256.0f / 65535);
    }
    const std::string floats =
        bytes_of_number(1.5f) + bytes_of_number(-2.0f) + bytes_of_number(1e-30f) + bytes_of_number(0.25f);
    for (const TiffImage& colour : read(tiff_by_hand(1, 1, 32, 4, kReal, floats))) {
        REQUIRE(colour.planes.size() == 3);
        CHECK(colour.linear);
        CHECK(colour.planes[1].at(0, 0) == -2);
        CHECK(colour.planes[2].at(0, 0) == 1e-30f);
        CHECK(colour.alpha.at(0, 0) == 0.25f);
    }
    const std::string halves =
        bytes_of_number(std::uint16_t{0x3c00}) + bytes_of_number(std::uint16_t{0xc000});
    for (const TiffImage& grey : read(tiff_by_hand(2, 1, 16, 1, kReal, halves))) {
        CHECK(grey.planes[0].at(0, 0) == 1);
        CHECK(grey.planes[0].at(1, 0) == -2);
    }
}

TEST_CASE("tiff: tiles are put together, and what they hold beyond the picture is left out") {
    for (const TiffImage& grey : read(tiled_by_hand())) {
        REQUIRE(grey.planes.size() == 1);
        REQUIRE(grey.planes[0].size == Size{20, 2});
        for (int y = 0; y < 2; ++y) {
            for (int x = 0; x < 20; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                CHECK(grey.planes[0].at(x, y) == static_cast<float>(x + 20 * y) / 255);
            }
        }
    }
}

TEST_CASE("tiff: what cannot be compared is named in one line") {
    const std::string pixels(4, '\x10'), good = tiff_by_hand(2, 2, 8, 1, kWhole, pixels);
    if (read(good).empty()) return;
    CHECK(contains(refusal(""), "a.tif: not a TIFF that can be compared"));
    CHECK(contains(refusal("GIF89a"), "; give grey or RGB, upright"));
    CHECK(contains(refusal(tiff_by_hand(2, 2, 32, 1, kWhole, std::string(16, '\1'))), "32 bits, format 1"));
    constexpr std::uint32_t kPhotometric = 262, kWhiteIsZero = 0;
    CHECK(contains(refusal(tiff_by_hand(2, 2, 8, 1, kWhole, pixels, {{kPhotometric, kWhiteIsZero}})),
                   "its 0 is white, not black: photometric 0"));
    constexpr std::uint16_t kCompression = 259, kOrientation = 274;
    CHECK(contains(refusal(tiff_by_hand(2, 2, 8, 1, kWhole, pixels, {{kOrientation, 4}})), "orientation 4"));
    constexpr std::uint32_t kFirstDirectory = 8;
    CHECK(contains(refusal(tiff_by_hand(2, 2, 8, 1, kWhole, pixels, {}, kFirstDirectory)),
                   "more than one picture"));
    CHECK(contains(refusal(tiff_by_hand(1u << 29, 1, 8, 1, kWhole, pixels, {{kCompression, 32773}})),
                   "its lines are longer than the file can hold"));
    CHECK(refusal(tiff_by_hand(2, 2, 8, 1, kWhole, pixels, {{256, 0}})) != "");
    CHECK(refusal(tiff_by_hand(60000, 60000, 8, 1, kWhole, pixels)) != "");
    for (std::size_t length = 0; length < good.size(); ++length) {
        CAPTURE(length);
        const std::string told = refusal(good.substr(0, length));
        CHECK(told.starts_with("a.tif: "));
        CHECK(told.find('\n') == std::string::npos);
    }
}
