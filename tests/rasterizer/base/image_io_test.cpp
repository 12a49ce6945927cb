#include "rasterizer/base/image_io.h"

#include <string>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/textures/texture.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
namespace fs = std::filesystem;

TEST_CASE("png: 8-bit values survive a round trip, grey and RGB") {
    const ScratchDirectory scratch;
    const Size size{16, 16};
    std::vector<std::uint8_t> grey(256), rgb;
    for (std::size_t i = 0; i < 256; ++i) {
        grey[i] = static_cast<std::uint8_t>(i);
        for (const std::size_t value : {i, 255 - i, i * 7 % 256})
            rgb.push_back(static_cast<std::uint8_t>(value));
    }
    write_png(scratch / "grey.png", size, 1, grey);
    write_png(scratch / "rgb.png", size, 3, rgb);
    const Image3 read_grey = read_png(scratch / "grey.png").colour,
                 read_rgb = read_png(scratch / "rgb.png").colour;
    REQUIRE(read_rgb.size() == size);
    for (int i = 0; i < 256; ++i) {
        CAPTURE(i);
        const float value = static_cast<float>(i) / 255;
        CHECK(read_grey.at(i % 16, i / 16) == glm::vec3(value));
        const glm::vec3 expected(value, static_cast<float>(255 - i) / 255,
                                 static_cast<float>(i * 7 % 256) / 255);
        CHECK(read_rgb.at(i % 16, i / 16) == expected);
    }
}

TEST_CASE("what cannot be stored is refused before a byte is written") {
    const ScratchDirectory scratch;
    const std::vector<std::uint8_t> none, four(4);
    CHECK_THROWS_AS(write_png(scratch / "a.png", {0, 0}, 1, none), OutputError);
    CHECK_THROWS_AS(write_png(scratch / "a.png", {50000, 85899}, 1, none), OutputError);
    CHECK_THROWS_AS(write_png(scratch / "a.png", {32768, 1}, 1, none), OutputError);
    CHECK_THROWS_AS(write_png(scratch / "a.png", {2, 2}, 2, four), OutputError);
    CHECK_THROWS_AS(write_png(scratch / "a.png", {2, 2}, 3, four), OutputError);
    CHECK_THROWS_AS(write_png(scratch / "a.png", {-1, 2}, 1, none), OutputError);
    CHECK_THROWS_AS(write_npy(scratch / "a.npy", Image<float>({0, 0}, 0)), OutputError);
    CHECK_THROWS_AS(write_npy(scratch / "a.npy", Image<float>({0, 5}, 0)), OutputError);
    Image<float> huge;
    huge.size = {50000, 85899};
    CHECK(contains(message_of<OutputError>([&] { write_npy(scratch / "a.npy", huge); }), "50000x85899"));
    CHECK(scratch.empty());
}
