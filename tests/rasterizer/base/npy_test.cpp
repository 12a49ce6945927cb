#include "rasterizer/base/npy.h"

#include <cstdint>
#include <cstring>
#include <string>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/wide.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

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
        {replaced(good, "\x01", "\x04"), "version 4.0"},
        {replaced(good, "\x01", "\x02"), "cut off inside its header"},
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

namespace {

// A .npy of one row of `count` values.
std::string npy_of(const std::string& descr, int count, const std::string& values,
                   const std::string& shape_end = "") {
    std::string header = "{'descr': '" + descr + "', 'fortran_order': False, 'shape': (1, " +
                         std::to_string(count) + shape_end + "), }\n";
    return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header + values;
}

template <class T>
std::string in_memory(std::initializer_list<T> values) {
    return {reinterpret_cast<const char*>(values.begin()), values.size() * sizeof(T)};
}

}  // namespace

TEST_CASE("npy: halves, doubles and integers are read as what they stand for") {
    const Planes halves =
        npy_image(npy_of("<f2", 4, in_memory<std::uint16_t>({0x3c00, 0xc100, 0x0001, 0x7bff})), "a").planes;
    CHECK(halves[0].at(0, 0) == 1.0f);
    CHECK(halves[0].at(1, 0) == -2.5f);
    CHECK(halves[0].at(2, 0) == 0x1p-24f);
    CHECK(halves[0].at(3, 0) == 65504.0f);

    const NpyImage doubles = npy_image(npy_of("<f8", 3, in_memory<double>({0.5, 0.1, 1e300})), "a");
    CHECK(doubles.planes[0].at(0, 0) == 0.5f);
    CHECK(doubles.planes[0].at(1, 0) == 0.1f);
    CHECK(doubles.planes[0].at(2, 0) == kInfinity);
    CHECK(doubles.rounded == 2);

    const NpyImage bytes = npy_image(npy_of("|u1", 2, in_memory<std::uint8_t>({255, 51})), "a");
    CHECK(bytes.planes[0].at(0, 0) == 1.0f);
    CHECK(bytes.planes[0].at(1, 0) == 0.2f);
    CHECK(bytes.rounded == 0);
    const NpyImage words = npy_image(npy_of("<u2", 2, in_memory<std::uint16_t>({65535, 13107})), "a");
    CHECK(words.planes[0].at(0, 0) == 1.0f);
    CHECK(words.planes[0].at(1, 0) == 0.2f);
}

TEST_CASE("npy: one to four components, one plane each") {
    for (const int components : {1, 2, 3, 4}) {
        CAPTURE(components);
        const std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8};
        const std::string of_two(reinterpret_cast<const char*>(values.data()),
                                 sizeof(float) * 2 * static_cast<std::size_t>(components));
        const Planes planes =
            npy_image(npy_of("<f4", 2, of_two, ", " + std::to_string(components)), "a").planes;
        REQUIRE(planes.size() == static_cast<std::size_t>(components));
        for (int c = 0; c < components; ++c) {
            CHECK(planes[static_cast<std::size_t>(c)].at(0, 0) == static_cast<float>(c + 1));
            CHECK(planes[static_cast<std::size_t>(c)].at(1, 0) == static_cast<float>(components + c + 1));
        }
        CHECK(npy_image(npy_bytes(planes), "b").planes[0].at(1, 0) == planes[0].at(1, 0));
    }
    for (const std::string shape_end : {", 5", ", 0", ", 1, 1"}) {
        CHECK(contains(message_of<InputError>([&] { npy_image(npy_of("<f4", 1, "", shape_end), "a.npy"); }),
                       "a.npy: shape is (1, 1" + shape_end + ")"));
    }
}

TEST_CASE("npy: the longer headers of versions 2 and 3 are read, other types are named") {
    std::string text = npy_of("<f4", 1, in_memory<float>({0.25f}));
    for (const char version : {'\2', '\3'}) {
        std::string longer = text;
        longer[6] = version;
        longer.insert(10, std::string(2, '\0'));
        CHECK(npy_image(longer, "a").planes[0].at(0, 0) == 0.25f);
    }
    for (const std::string descr : {">f4", "<i4", "|b1", "<c8"}) {
        CHECK(contains(message_of<InputError>([&] { npy_image(npy_of(descr, 1, "1234"), "a.npy"); }),
                       "a.npy: values of type '" + descr + "'; give a .npy of f2, f4"));
    }
}
