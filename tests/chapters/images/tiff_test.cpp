// TIFFs put together by hand are read as the format says; what cannot be read is named.
#include "chapters/images/tiff.h"

#include <cstdint>
#include <cstring>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/error_message.h"

using namespace crevice;

namespace {

template <class T>
std::string number(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

struct Tag {
    std::uint16_t tag;
    std::uint32_t value;
};

// One strip, little-endian: TIFF 6.0, section 2. `other` tags replace those of the same number.
std::string tiff_by_hand(std::uint32_t width, std::uint32_t height, std::uint32_t bits, std::uint32_t samples,
                         std::uint32_t format, const std::string& pixels,
                         const std::vector<Tag>& other = {}) {
    std::vector<Tag> tags = {{256, width},
                             {257, height},
                             {258, bits},
                             {259, 1},
                             {262, samples >= 3 ? 2u : 1u},
                             {273, 0},
                             {277, samples},
                             {278, height},
                             {279, static_cast<std::uint32_t>(pixels.size())},
                             {339, format}};
    for (const Tag& changed : other) {
        for (Tag& tag : tags) {
            if (tag.tag == changed.tag) tag = changed;
        }
    }
    const bool many = samples > 2;  // then these are arrays, behind the directory
    const std::uint32_t end = 8 + 2 + 12 * static_cast<std::uint32_t>(tags.size()) + 4;
    std::string arrays;
    std::string file =
        std::string("II*\0", 4) + number(std::uint32_t{8}) + number(static_cast<std::uint16_t>(tags.size()));
    for (const Tag& tag : tags) {
        const bool each = tag.tag == 258 || tag.tag == 339;
        std::uint32_t value = tag.value;
        if (tag.tag == 273) value = end + (many ? 4 * samples : 0);
        if (each && many) value = end + static_cast<std::uint32_t>(arrays.size());
        if (each && !many && samples == 2) value = tag.value | tag.value << 16;
        if (each && many) {
            for (std::uint32_t s = 0; s < samples; ++s)
                arrays += number(static_cast<std::uint16_t>(tag.value));
        }
        file += number(tag.tag) + number(std::uint16_t{each ? std::uint16_t{3} : std::uint16_t{4}}) +
                number(each ? samples : 1u) + number(value);
    }
    return file + number(std::uint32_t{0}) + arrays + pixels;
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
    const std::string words =
        number(std::uint16_t{1}) + number(std::uint16_t{65535}) + number(std::uint16_t{256});
    for (const TiffImage& colour : read(tiff_by_hand(1, 1, 16, 3, kWhole, words))) {
        REQUIRE(colour.planes.size() == 3);
        CHECK(colour.planes[0].at(0, 0) == 1.0f / 65535);
        CHECK(colour.planes[1].at(0, 0) == 1);
        CHECK(colour.planes[2].at(0, 0) == 256.0f / 65535);
    }
    const std::string floats = number(1.5f) + number(-2.0f) + number(1e-30f) + number(0.25f);
    for (const TiffImage& colour : read(tiff_by_hand(1, 1, 32, 4, kReal, floats))) {
        REQUIRE(colour.planes.size() == 3);
        CHECK(colour.linear);
        CHECK(colour.planes[1].at(0, 0) == -2);
        CHECK(colour.planes[2].at(0, 0) == 1e-30f);
        CHECK(colour.alpha.at(0, 0) == 0.25f);
    }
    const std::string halves = number(std::uint16_t{0x3c00}) + number(std::uint16_t{0xc000});
    for (const TiffImage& grey : read(tiff_by_hand(2, 1, 16, 1, kReal, halves))) {
        CHECK(grey.planes[0].at(0, 0) == 1);
        CHECK(grey.planes[0].at(1, 0) == -2);
    }
}

TEST_CASE("tiff: what cannot be compared is named in one line") {
    const std::string pixels(4, '\x10'), good = tiff_by_hand(2, 2, 8, 1, kWhole, pixels);
    if (read(good).empty()) return;
    CHECK(contains(refusal(""), "a.tif: not a TIFF that can be compared"));
    CHECK(contains(refusal("GIF89a"), "; give grey or RGB in strips"));
    CHECK(contains(refusal(tiff_by_hand(2, 2, 32, 1, kWhole, std::string(16, '\1'))), "32 bits, format 1"));
    constexpr std::uint32_t kPhotometric = 262, kWhiteIsZero = 0;
    CHECK(contains(refusal(tiff_by_hand(2, 2, 8, 1, kWhole, pixels, {{kPhotometric, kWhiteIsZero}})),
                   "photometric 0"));
    CHECK(refusal(tiff_by_hand(2, 2, 8, 1, kWhole, pixels, {{256, 0}})) != "");
    CHECK(refusal(tiff_by_hand(60000, 60000, 8, 1, kWhole, pixels)) != "");
    for (std::size_t length = 0; length < good.size(); ++length) {
        CAPTURE(length);
        const std::string told = refusal(good.substr(0, length));
        CHECK(told.starts_with("a.tif: "));
        CHECK(told.find('\n') == std::string::npos);
    }
}
