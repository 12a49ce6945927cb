#include "rasterizer/base/image_io.h"
#include "rasterizer/textures/texture.h"

#include <cstring>
#include <string>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/wide.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/special_floats.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

// Every kind of float: NaN with a payload, both infinities, -0, a denormal, and numbers that differ by pixel.
Image<float> awkward_image(Size size) {
    const float special[] = {float_from_bits(0x7fc12345), kInfinity, -kInfinity, -0.0f, 1e-42f};
    Image<float> image(size, 7.0f);  // the padding stays 7
    int i = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x, ++i)
            image.at(x, y) = i < 5 ? special[i] : static_cast<float>(i) / 3;
    }
    return image;
}

bool same_bits(const Image<float>& a, const Image<float>& b) {
    if (!(a.size == b.size)) return false;
    for (int y = 0; y < a.size.height; ++y) {
        if (std::memcmp(a.row(y), b.row(y), sizeof(float) * static_cast<std::size_t>(a.size.width)) != 0)
            return false;
    }
    return true;
}

// The message of the error of type E that `call` throws, or "" when it throws none.
template <class E, class Call>
std::string message_of(Call call) {
    try {
        call();
    } catch (const E& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("npy: every bit of a value survives a round trip, at widths with and without row padding") {
    const ScratchDirectory scratch;
    for (const Size size : {Size{1, 1}, Size{7, 3}, Size{8, 2}, Size{1, 9}, Size{33, 5}}) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        const Image<float> image = awkward_image(size);
        write_npy(scratch / "a.npy", image);
        const Planes read = read_npy(scratch / "a.npy");
        REQUIRE(read.size() == 1);
        CHECK(same_bits(read[0], image));

        Image3 colour(size, {1, 2, 3});
        colour.y = image;
        write_npy(scratch / "c.npy", colour);
        const Planes planes = read_npy(scratch / "c.npy");
        REQUIRE(planes.size() == 3);
        CHECK(same_bits(planes[0], colour.x));
        CHECK(same_bits(planes[1], image));
        CHECK(same_bits(planes[2], colour.z));
    }
}

TEST_CASE("npy: the bytes are NumPy's") {
    Image<float> image({2, 3}, 0.0f);
    image.at(1, 0) = 1.0f;
    const std::string bytes = npy_bytes(image);
    const std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 2), }";
    REQUIRE(bytes.size() == 128 + 6 * 4);
    CHECK(bytes.substr(0, 10) == std::string("\x93NUMPY\x01\x00\x76\x00", 10));
    CHECK(bytes.substr(10, header.size()) == header);
    CHECK(bytes.substr(10 + header.size(), 117 - header.size()) == std::string(117 - header.size(), ' '));
    CHECK(bytes[127] == '\n');
    // Row 0 first, little-endian: 0.0f, then 1.0f.
    CHECK(bytes.substr(128, 8) == std::string("\0\0\0\0\0\0\x80\x3f", 8));
    const std::string colour = npy_bytes(Image3({2, 3}, {1, 0, 0}));
    CHECK(contains(colour, "'shape': (3, 2, 3), }"));
    // Components of a pixel lie together: 1, 0, 0, 1.
    CHECK(colour.substr(128, 16) == std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\x80\x3f", 16));
}

TEST_CASE("npy: what is not <f4 in C order of a known shape is named") {
    const std::string good = npy_bytes(Image<float>({5, 4}, 0.5f));
    struct Bad {
        std::string bytes, said;
    };
    const Bad cases[] = {
        {"", "not a .npy file"},
        {"\x93NUMPX" + good.substr(6), "not a .npy file"},
        {good.substr(0, 9), "not a .npy file"},
        {good.substr(0, 60), "cut off inside its header"},
        {good.substr(0, good.size() - 1), "holds 79 bytes of values where its shape needs 80"},
        {good + "x", "holds 81 bytes of values where its shape needs 80"},
        {replaced(good, "\x01", "\x02"), "version 2.0"},
        {good.substr(0, 7) + "\x01" + good.substr(8), "version 1.1"},
        {replaced(good, "<f4", "<f8"), "type '<f8'"},
        {replaced(good, "<f4", "|u1"), "type '|u1'"},
        {replaced(good, "<f4", ">f4"), "type '>f4'"},
        {replaced(good, "'<f4', ", "[('a', '<f4')], "), "type [('a', '<f4')]"},
        {replaced(good, "False", "True "), "fortran_order is True"},
        {replaced(good, "(4, 5)", "(20, )"), "shape is (20, )"},
        {replaced(good, "(4, 5)", "(0, 5)"), "shape is (0, 5)"},
        {replaced(good, "(4, 5)", "(-4, 5)"), "shape is (-4, 5)"},
        {replaced(good, "(4, 5)", "(4 5)"), "shape is (4 5)"},
        {replaced(good, "(4, 5)", "(4, 5, 4)"), "shape is (4, 5, 4)"},
        {replaced(good, "(4, 5)", "(99999999999, 5)"), "shape is (99999999999, 5)"},
        {replaced(good, "(4, 5)", "(85899, 50000)"), "shape is (85899, 50000)"},
        {replaced(good, "(4, 5)", "(4, 5"), "shape is"},
        {replaced(good, "'shape'", "'shap3'"), "no 'shape'"},
    };
    for (const Bad& bad : cases) {
        CAPTURE(bad.said);
        const std::string message = message_of<InputError>([&] { planes_from_npy(bad.bytes, "x.npy"); });
        CAPTURE(message);
        CHECK(contains(message, "x.npy: "));
        CHECK(contains(message, bad.said));
    }
}

TEST_CASE("npy: a missing file and a directory are named") {
    const ScratchDirectory scratch;
    CHECK(contains(message_of<InputError>([&] { read_npy(scratch / "none.npy"); }), "none.npy"));
    CHECK(contains(message_of<InputError>([&] { read_npy(scratch.path()); }), "directory"));
}

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
