// EXRs: what was written is read with the same bits; files that were put together by hand are read as they should be; and
// what cannot be read is named.
#include "chapters/images/exr.h"

#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "tests/tools/error_message.h"
#include "tests/tools/exr_by_hand.h"
#include "tests/tools/has_openexr.h"

using namespace crevice;

namespace {

// Every kind of float, and no two pixels alike.
Image<float> floats(Size size, float from) {
    Image<float> image(size, 0.0f);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image.at(x, y) = from + 0.1f * static_cast<float>(size.width * y + x);
    image.at(0, 0) = std::numeric_limits<float>::infinity();
    image.at(1, 0) = -0.0f;
    image.at(2, 0) = std::numeric_limits<float>::quiet_NaN();
    image.at(3, 0) = 1e-42f;
    return image;
}

std::string line_of(std::initializer_list<float> values) {
    std::string bytes;
    for (const float value : values) bytes += exr_number(value);
    return bytes;
}
std::string line_of_codes(std::initializer_list<std::uint16_t> codes) {
    std::string bytes;
    for (const std::uint16_t code : codes) bytes += exr_number(code);
    return bytes;
}

std::string refusal(const std::string& bytes) {
    try {
        exr_layers(bytes, "a.exr");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::vector<std::string> names_of(const std::vector<ExrLayer>& layers) {
    std::vector<std::string> names;
    for (const ExrLayer& layer : layers) names.push_back(layer.name);
    return names;
}

}  // namespace

TEST_CASE("exr: layers of two sizes are read with the bits with which they were written") {
    if (!has_openexr()) return;
    const Size whole{37, 21}, half{19, 11};
    const Image<float> x = floats(whole, 1), y = floats(whole, 2), z = floats(whole, 3),
                       raw = floats(half, 4), blurred = floats(half, 5);
    const ExrChannel channels[] = {{"normal.X", &x}, {"normal.Y", &y}, {"normal.Z", &z},
                                   {"depth.Z", &y},  {"lit.R", &z},    {"lit.G", &y},
                                   {"lit.B", &x},    {"ao.raw", &raw}, {"ao.blurred", &blurred}};
    const std::string bytes = exr_bytes(channels);
    CHECK(exr_bytes(channels) == bytes);
    for (const ExrLayer& layer : exr_layers(bytes, "a.exr")) {
        CAPTURE(layer.name);
        const std::vector<const Image<float>*> wanted = layer.name == "normal"   ? std::vector{&x, &y, &z}
                                                        : layer.name == "depth"  ? std::vector{&y}
                                                        : layer.name == "lit"    ? std::vector{&z, &y, &x}
                                                        : layer.name == "ao_raw" ? std::vector{&raw}
                                                                                 : std::vector{&blurred};
        REQUIRE(layer.planes.size() == wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i)
            CHECK(content_hash(layer.planes[i]) == content_hash(*wanted[i]));
        CHECK(layer.colour == (layer.name == "lit"));
        CHECK(layer.alpha.empty());
    }
    CHECK(names_of(exr_layers(bytes, "a.exr")) ==
          std::vector<std::string>{"depth", "lit", "normal", "ao_blurred", "ao_raw"});
    // One size: a plain file, for readers that know no parts. Byte 5 of the version says which.
    CHECK((exr_bytes(std::span(channels).first(7))[5] & 0x10) == 0);
    CHECK((bytes[5] & 0x10) != 0);
}

TEST_CASE("exr: a file put together by hand is read as its layout says, float and half, window and alpha") {
    if (!has_openexr()) return;
    const std::vector<HandMadeChannel> channels = {
        {"A", 2, 1, {line_of({0.5f, 1}), line_of({0, 0.25f})}},
        {"B", 1, 1, {line_of_codes({0x3c00, 0x0001}), line_of_codes({0x7c00, 0xc000})}},
        {"G", 2, 1, {line_of({3, 4}), line_of({5, 6})}},
        {"R", 2, 1, {line_of({7, 8}), line_of({9, 10})}},
        {"Z", 2, 1, {line_of({11, 12}), line_of({13, 14})}},
    };
    for (const int first : {0, -3, 1000}) {
        CAPTURE(first);
        const std::vector<ExrLayer> layers = exr_layers(exr_by_hand({2, 2}, channels, first), "a.exr");
        REQUIRE(names_of(layers) == std::vector<std::string>{"", "Z"});
        const ExrLayer& colour = layers[0];
        REQUIRE(colour.planes.size() == 3);
        CHECK(colour.colour);
        CHECK(colour.planes[0].at(0, 0) == 7);
        CHECK(colour.planes[0].at(1, 1) == 10);
        CHECK(colour.planes[1].at(0, 1) == 5);
        CHECK(colour.planes[2].at(0, 0) == 1);
        CHECK(colour.planes[2].at(1, 0) == 0x1p-24f);
        CHECK(colour.planes[2].at(0, 1) == std::numeric_limits<float>::infinity());
        CHECK(colour.planes[2].at(1, 1) == -2);
        CHECK(colour.alpha.at(1, 1) == 0.25f);
        CHECK(layers[1].planes.size() == 1);
        CHECK(layers[1].planes[0].at(0, 1) == 13);
    }
}

TEST_CASE("exr: what cannot be compared is named in one line") {
    if (!has_openexr()) return;
    const std::vector<HandMadeChannel> grey = {{"Y", 2, 1, {line_of({1, 2}), line_of({3, 4})}}};
    const std::string good = exr_by_hand({2, 2}, grey);
    REQUIRE(exr_layers(good, "a.exr")[0].planes[0].at(1, 1) == 4);
    CHECK(contains(refusal(""), "a.exr: not an EXR that can be compared"));
    CHECK(contains(refusal("P6 1 1 255 abc"), "; give one of float or half channels"));
    CHECK(contains(refusal(exr_by_hand({2, 2}, {{"id", 0, 1, {line_of({1, 2}), line_of({3, 4})}}})),
                   "whole numbers (channel id)"));
    CHECK(contains(refusal(exr_by_hand({2, 2}, {{"BY", 2, 2, {line_of({1}), ""}}})),
                   "fewer values than pixels (channel BY)"));
    constexpr std::int32_t kDeep = 0x800;
    const std::string deep =
        exr_attribute("type", "string", "deepscanline") + exr_attribute("name", "string", "a") +
        exr_attribute("version", "int", exr_number(1)) + exr_attribute("chunkCount", "int", exr_number(2)) +
        exr_attribute("maxSamplesPerPixel", "int", exr_number(1));
    CHECK(contains(refusal(exr_by_hand({2, 2}, grey, 0, kDeep, deep)), "deep"));
    // A few bytes that promise a large picture: nothing of its size is allocated.
    CHECK(contains(refusal(exr_by_hand({30000, 30000}, grey).substr(0, 2000)), "cut short"));
    CHECK(refusal(exr_by_hand({2'000'000'000, 1}, {{"Y"}})) != "");
    for (std::size_t length = 0; length < good.size(); ++length) {
        CAPTURE(length);
        const std::string told = refusal(good.substr(0, length));
        CHECK(told.starts_with("a.exr: "));
        CHECK(told.find('\n') == std::string::npos);
    }
}

TEST_CASE("exr: a file with any one byte changed is read or refused") {
    if (!has_openexr()) return;
    const Image<float> plane = floats({8, 8}, 1);
    const ExrChannel channels[] = {{"ao.raw", &plane}};
    const std::string good = exr_bytes(channels);
    int refused = 0;
    for (std::size_t at = 0; at < good.size(); ++at) {
        CAPTURE(at);
        for (const char by : {'\x00', '\x7f', '\xff'}) {
            std::string bytes = good;
            bytes[at] = by;
            try {
                for (const ExrLayer& layer : exr_layers(bytes, "a.exr")) CHECK(!layer.planes.empty());
            } catch (const InputError&) {
                ++refused;
            }
        }
    }
    CHECK(refused > 100);
}
