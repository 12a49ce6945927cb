#include "rasterizer/textures/texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_intact.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/every_run.h"
#include "tests/tools/noise.h"
#include "tests/tools/picture_files.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string error_of(const std::filesystem::path& path) {
    try {
        load_texture(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

// RGB pixels that all differ, row 0 first.
std::vector<std::uint8_t> varied_pixels(Size size) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < size.width * size.height * 3; ++i)
        pixels.push_back(static_cast<std::uint8_t>(i * 37 + i / 7));
    return pixels;
}

std::string small_png() { return png_bytes({5, 3}, 3, varied_pixels({5, 3})); }

double mean_of(const Image<float>& image) {
    double sum = 0;
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) sum += static_cast<double>(image.at(x, y));
    }
    return sum / image.size.width / image.size.height;
}

}  // namespace

TEST_CASE("build_texture: every level keeps the mean and has the size it should") {
    const std::vector<Size> sizes = {{1, 1}, {8, 8}, {256, 64}, {2, 1},   {1, 7},
                                     {3, 3}, {5, 3}, {17, 31},  {100, 1}, {63, 64}};
    for (const Size size : sizes) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        Image3 base(size, glm::vec3(0));
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const auto h = static_cast<std::uint32_t>(x * 7919 + y * 104729) * 2654435761u;
                base.set(x, y, glm::vec3(h >> 24, (h >> 16) & 255u, x == 0 && y == 0 ? 255u : 0u) / 255.0f);
            }
        }
        const Texture texture = build_texture(base);
        Size expected = size;
        for (std::size_t level = 0; level < texture.levels().size(); ++level) {
            CAPTURE(level);
            const Image3 mip = texture.colour(level);
            CHECK(mip.size() == expected);
            CHECK(std::abs(mean_of(mip.x) - mean_of(base.x)) < static_cast<double>(kTexelError) + 1e-6);
            CHECK(std::abs(mean_of(mip.y) - mean_of(base.y)) < static_cast<double>(kTexelError) + 1e-6);
            CHECK(std::abs(mean_of(mip.z) - mean_of(base.z)) < static_cast<double>(kTexelError) + 1e-6);
            expected = {std::max(1, expected.width / 2), std::max(1, expected.height / 2)};
        }
        CHECK(texture.levels().back().size == Size{1, 1});
    }
}

TEST_CASE("build_texture: halving is the exact mean of four, an odd side weighs by area") {
    Image3 four({2, 2}, glm::vec3(0));
    four.x.at(0, 0) = 0.25f;
    four.x.at(1, 0) = 0.5f;
    four.x.at(0, 1) = 1.0f;
    CHECK(build_texture(four).colour(1).x.at(0, 0) == 0.4375f);
    Image3 five({5, 1}, glm::vec3(0));
    five.x.at(2, 0) = 1.0f;  // the middle pixel falls half to each side
    const Texture texture = build_texture(five);
    CHECK(texture.colour(1).x.at(0, 0) == 0.2f);
    CHECK(texture.colour(1).x.at(1, 0) == 0.2f);
}

TEST_CASE("build_texture: the same bits at every lane count, instruction set and thread count") {
    for (const Size size : {Size{64, 40}, {33, 17}, {5, 70}}) {
        Image3 base(size, glm::vec3(0));
        Image<float> alpha(size, 0.0f);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                base.set(x, y, {noise(1, x, y), noise(2, x, y), noise(3, x, y)});
                alpha.at(x, y) = noise(4, x, y);
            }
        }
        const Texture plain = build_texture(base, alpha, {.threads = 1, .lanes = 1});
        for (const Run& run : every_run()) {
            INFO(run_text(run), ", ", size.width, " x ", size.height);
            const Texture texture = build_texture(base, alpha, run);
            REQUIRE(texture.levels().size() == plain.levels().size());
            for (std::size_t level = 0; level < texture.levels().size(); ++level) {
                CHECK(texture.colour(level).x.pixels == plain.colour(level).x.pixels);
                CHECK(texture.colour(level).y.pixels == plain.colour(level).y.pixels);
                CHECK(texture.colour(level).z.pixels == plain.colour(level).z.pixels);
                CHECK(texture.alpha(level).pixels == plain.alpha(level).pixels);
            }
        }
    }
}

TEST_CASE("texture: a level is given back as it was added") {
    Image3 base({5, 3}, glm::vec3(0));
    Image<float> alpha({5, 3}, 0.0f);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            base.set(x, y, glm::vec3(x, y, x * y) / 16.0f);
            alpha.at(x, y) = static_cast<float>(x + y) / 8;
        }
    }
    Texture texture;
    texture.add_level(base, alpha);
    texture.add_level(Image3({2, 1}, glm::vec3(0.75f)), Image<float>({2, 1}, 0.25f));
    CHECK(texture.size() == Size{5, 3});
    CHECK(texture.has_alpha());
    CHECK(texture.texel(0, 4, 1) == glm::vec4(4 / 16.0f, 1 / 16.0f, 4 / 16.0f, 5 / 8.0f));
    CHECK(texture.texel(1, 1, 0) == glm::vec4(0.75f, 0.75f, 0.75f, 0.25f));
    CHECK(texture.colour(0).x.pixels == base.x.pixels);
    CHECK(texture.colour(0).y.pixels == base.y.pixels);
    CHECK(texture.colour(0).z.pixels == base.z.pixels);
    CHECK(texture.alpha(0).pixels == alpha.pixels);
    CHECK(build_texture(base).alpha(0).empty());
    CHECK(build_texture(base).texel(0, 0, 0).w == 1);
}

TEST_CASE("texture: what is no level is named") {
    const Image3 base({4, 4}, glm::vec3(0)), half({2, 2}, glm::vec3(0));
    Texture texture;
    CHECK_THROWS_WITH_AS(texture.add_level(Image3()), doctest::Contains("no texels"), UsageError);
    CHECK_THROWS_WITH_AS(texture.add_level(base, Image<float>({2, 2}, 1.0f)),
                         doctest::Contains("2 x 2, not 4 x 4"), UsageError);
    texture.add_level(base);
    CHECK_THROWS_WITH_AS(texture.add_level(base), doctest::Contains("4 x 4 after 4 x 4"), UsageError);
    CHECK_THROWS_WITH_AS(texture.add_level(half, Image<float>({2, 2}, 1.0f)),
                         doctest::Contains("some levels"), UsageError);
    CHECK_NOTHROW(texture.add_level(half));
    CHECK(texture.levels().size() == 2);
    CHECK_THROWS_WITH_AS(build_texture(Image3()), doctest::Contains("no texels"), UsageError);
}

TEST_CASE("load_texture: PNG codes become linear light, row 0 on top") {
    const ScratchDirectory scratch;
    const std::vector<std::uint8_t> pixels = varied_pixels({5, 3});
    write_bytes(scratch / "a.png", small_png());
    const Texture texture = load_texture(scratch / "a.png");
    REQUIRE(texture.colour(0).size() == Size{5, 3});
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            const std::uint8_t red = pixels[static_cast<std::size_t>((y * 5 + x) * 3)];
            CHECK(std::abs(texture.colour(0).x.at(x, y) - linear_from_srgb(static_cast<float>(red) / 255)) <=
                  kTexelError);
        }
    }
}

TEST_CASE("load_texture: black is 0 and white is 1, exactly") {
    const ScratchDirectory scratch;
    const std::vector<std::uint8_t> pixels = {0, 255};
    write_bytes(scratch / "a.png", png_bytes({2, 1}, 1, pixels));
    const Texture texture = load_texture(scratch / "a.png");
    CHECK(texture.colour(0).at(0, 0) == glm::vec3(0));
    CHECK(texture.colour(0).at(1, 0) == glm::vec3(1));
    CHECK(texture.colour(1).at(0, 0) == glm::vec3(0.5f));
}

TEST_CASE("load_texture: TGA, plain and run-length coded, and JPEG") {
    const ScratchDirectory scratch;
    const std::string blue_green_red("\x40\x80\xff", 3);
    const std::string plain = tga_header(2, {2, 1}, 24, 0x20) + blue_green_red + std::string("\0\0\0", 3);
    std::string coded = tga_header(10, {4, 1}, 24, 0x20);
    coded += '\x83' + blue_green_red;
    write_bytes(scratch / "plain.tga", plain);
    write_bytes(scratch / "coded.tga", coded);
    write_bytes(scratch / "grey.jpg", grey_jpeg());
    const glm::vec3 colour(1, linear_from_srgb(128.0f / 255), linear_from_srgb(64.0f / 255));
    const auto nearly = [](glm::vec3 a, glm::vec3 b) {
        return glm::all(glm::lessThanEqual(glm::abs(a - b), glm::vec3(kTexelError)));
    };
    CHECK(nearly(load_texture(scratch / "plain.tga").colour(0).at(0, 0), colour));
    CHECK(load_texture(scratch / "plain.tga").colour(0).at(1, 0) == glm::vec3(0));
    CHECK(nearly(load_texture(scratch / "coded.tga").colour(0).at(3, 0), colour));
    const Texture grey = load_texture(scratch / "grey.jpg");
    CHECK(grey.colour(0).size() == Size{8, 8});
    CHECK(nearly(grey.colour(0).at(7, 7), glm::vec3(linear_from_srgb(128.0f / 255))));
}

TEST_CASE("load_texture: a picture cut short anywhere is an InputError") {
    const ScratchDirectory scratch;
    const std::string blue_green_red("\x40\x80\xff", 3);
    const std::vector<std::string> pictures = {
        small_png(), grey_jpeg(), tga_header(2, {2, 1}, 24, 0x20) + blue_green_red + blue_green_red,
        tga_header(10, {4, 1}, 24, 0x20) + ('\x83' + blue_green_red)};
    for (std::size_t which = 0; which < pictures.size(); ++which) {
        for (std::size_t length = 0; length < pictures[which].size(); ++length) {
            CAPTURE(which);
            CAPTURE(length);
            write_bytes(scratch / "cut", pictures[which].substr(0, length));
            CHECK_THROWS_AS(load_texture(scratch / "cut"), InputError);
        }
    }
}

TEST_CASE("load_texture: no byte of a PNG can change unnoticed") {
    const ScratchDirectory scratch;
    const std::string good = small_png();
    for (std::size_t byte = 0; byte < good.size(); ++byte) {
        std::string damaged = good;
        damaged[byte] = static_cast<char>(damaged[byte] ^ (1 << (byte % 8)));
        CAPTURE(byte);
        write_bytes(scratch / "damaged.png", damaged);
        CHECK_THROWS_AS(load_texture(scratch / "damaged.png"), InputError);
    }
}

TEST_CASE("load_texture: what is no picture is named with what to do") {
    const ScratchDirectory scratch;
    CHECK(error_of(scratch / "missing.png").find("missing.png: there is no such file") != std::string::npos);
    CHECK(error_of(scratch.path()).find("is a directory") != std::string::npos);
    write_bytes(scratch / "empty.png", "");
    CHECK(error_of(scratch / "empty.png").find("; ") != std::string::npos);
    write_bytes(scratch / "text.png", "This is not a picture, though it is long enough to be one.\n");
    CHECK(error_of(scratch / "text.png").find("text.png: ") != std::string::npos);
    CHECK(damage_in_image(small_png()).empty());
}

TEST_CASE("load_texture: a size beyond the limit is refused before decoding") {
    const ScratchDirectory scratch;
    // The header alone says 20000 x 1; there are no pixels to decode.
    write_bytes(scratch / "wide.tga", tga_header(2, {20000, 1}, 24, 0x20) + std::string(60000, '\0'));
    CHECK(error_of(scratch / "wide.tga").find("20000 x 1") != std::string::npos);
}
