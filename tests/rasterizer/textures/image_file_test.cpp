#include "rasterizer/textures/image_file.h"

#include <fstream>
#include <tuple>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/picture_files.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
using namespace std::string_literals;

namespace {

std::string error_of(const std::string& bytes) {
    try {
        decode_image(bytes, "t.png", TextureEncoding::srgb);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

// Little-endian, of ASCII, behind a byte order mark.
std::string utf16(std::string mark, const std::string& text) {
    for (const char c : text) mark += std::string{c, '\0'};
    return mark;
}

ImageCodes codes_of(const std::string& bytes) {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "a.png", std::ios::binary) << bytes;
    return read_png(scratch / "a.png");
}

}  // namespace

TEST_CASE("decode_image: a file of another kind is named for what it is") {
    struct Row {
        std::string bytes, kind;
    };
    const std::vector<Row> rows = {
        {"II*\0\x08\0\0\0"s, "TIFF"},
        {"MM\0*\0\0\0\x08"s, "TIFF"},
        {"RIFF\x10\0\0\0WEBPVP8L"s, "WebP"},
        {"8BPS\0\1"s, "PSD"},
        {"\x76\x2f\x31\x01\x02\0\0\0"s, "OpenEXR"},
        {"\xabKTX 20\xbb\r\n\x1a\n"s, "KTX2"},
        {"DDS |\0\0\0"s, "DDS"},
        {"\0\0\0\x0cjP  \r\n\x87\n"s, "JPEG 2000"},
        {"\xff\x4f\xff\x51\0\x2f"s, "JPEG 2000"},
        {"\0\0\0\x1c"s + "ftypavif", "AVIF"},
        {"\0\0\0\x1c"s + "ftypheic", "HEIF"},
        {"GIF89a\x10\0\x10\0"s, "GIF"},
        {"BM\x36\0\0\0"s, "BMP"},
        {"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "Radiance"},
        {"P6\n2 2\n255\n", "PNM"},
        {"<svg xmlns=\"http://www.w3.org/2000/svg\"/>", "SVG"},
        {"<?xml version=\"1.0\"?>\n<!-- made by hand -->\n<svg/>", "SVG"},
        {"\xEF\xBB\xBF\n<!DOCTYPE html>\n<html><body>404</body></html>", "HTML"},
        {"<HTML><HEAD></HEAD></HTML>", "HTML"},
        {"version https://git-lfs.github.com/spec/v1\noid sha256:1234\nsize 12\n", "Git LFS pointer"},
        {"%PDF-1.7\n", "PDF"},
        {byte_string({0, 0, 1, 0, 1, 0, 16, 16, 0, 0, 1, 0, 32, 0, 0, 4, 0, 0, 22, 0, 0, 0}), "icon (ICO)"},
        {byte_string({0, 0, 2, 0, 1, 0, 16, 16, 0, 0, 1, 0, 1, 0, 0, 4, 0, 0, 22, 0, 0, 0}), "cursor (CUR)"},
        {"\x0a\5\1\x08\0\0\0\0\x0f\0\x0f\0"s, "PCX"},
        {"\1\xda\1\1\0\3"s, "SGI"},
        {"PF\n2 2\n-1.0\n", "PFM"},
        {"\x13\xab\xa1\x5c\4\4\1"s, "ASTC"},
        {"PKM 10\0\0"s, "PKM"},
        {"II\xbc\1\x20\0\0\0"s, "JPEG XR"},
        {"BPG\xfb\x20\0"s, "BPG"},
        {"FLIF44\1", "FLIF"},
        {"\x8aMNG\r\n\x1a\n", "MNG"},
        {"\x8bJNG\r\n\x1a\n", "JNG"},
        {"RIFF\x10\0\0\0AVI LIST"s, "film"},
        {"SDPX\0\0\x20\0"s, "DPX"},
        {"XPDS\0\x20\0\0"s, "DPX"},
        {"\x80\x2a\x5f\xd7\0\0\4\0"s, "Cineon"},
        {"FORM\0\0\0\x20ILBMBMHD"s, "IFF"},
        {byte_string({1, 0, 0, 0}) + std::string(36, '\1') + " EMF", "EMF"},
        {"\xd7\xcd\xc6\x9a\0\0"s, "WMF"},
        {"icns\0\0\x20\0"s, "ICNS"},
        {"\x59\xa6\x6a\x95\0\0\0\2"s, "Sun raster"},
        {utf16("\xff\xfe", "<?xml version=\"1.0\"?><svg/>"), "SVG"},
        {utf16("", "<svg/>"), "SVG"},
        {"", "empty file"},
        {"not a picture at all, only some words", "text"},
        {"\1\2\3\4\5\6\7\x08"s, "nothing that is known"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.kind);
        const std::string error = error_of(row.bytes);
        CAPTURE(error);
        CHECK(error.find("t.png: ") == 0);
        CHECK(error.find(row.kind) != std::string::npos);
        CHECK(error.find("convert it to PNG") != std::string::npos);
        CHECK(error.find('\n') == std::string::npos);
    }
}

TEST_CASE("decode_image: Apple's PNG variant has its colours in order and freed of alpha") {
    // Blue, green, red, alpha: (200, 100, 50) opaque, and (254, 128, 0) times 1/2.
    const std::string stored = "\x32\x64\xc8\xff\0\x40\x7f\x80"s;
    const DecodedImage apple =
        decode_image(png_file({2, 1}, {.apple = true}, stored), "k.png", TextureEncoding::linear);
    CHECK(apple.colour.at(0, 0) == glm::vec3(200, 100, 50) / 255.0f);
    CHECK(apple.alpha.at(1, 0) == 128.0f / 255);
    CHECK(std::abs(apple.colour.at(1, 0).x - 254.0f / 255) < 1.01f / 255);
    CHECK(std::abs(apple.colour.at(1, 0).y - 128.0f / 255) < 1.01f / 255);
    CHECK(apple.colour.at(1, 0).z == 0);
    // A common PNG is not touched by it.
    const DecodedImage common = decode_image(png_file({2, 1}, {}, stored), "k.png", TextureEncoding::linear);
    CHECK(common.colour.at(0, 0) == glm::vec3(50, 100, 200) / 255.0f);
    CHECK(common.colour.at(1, 0) == glm::vec3(0, 64, 127) / 255.0f);
}

TEST_CASE("decode_image: Apple's deflate streams end without a check sum") {
    // Four rows of four such pixels, deflated: the last code ends with the last byte.
    const std::string deflated =
        byte_string({0x63, 0x30, 0x4a, 0x39, 0xf1, 0x1f, 0x19, 0x33, 0x90, 0x2e, 0, 0});
    const std::string file = "\x89PNG\r\n\x1a\n" + png_chunk("CgBI", "\x50\0\x20\2"s) +
                             png_chunk("IHDR", "\0\0\0\4\0\0\0\4\x08\6\0\0\0"s);
    const std::string end = png_chunk("IEND", "");
    for (const std::string& pixels :
         {png_chunk("IDAT", deflated),
          png_chunk("IDAT", deflated.substr(0, 5)) + png_chunk("IDAT", deflated.substr(5))}) {
        const DecodedImage image = decode_image(file + pixels + end, "k.png", TextureEncoding::linear);
        REQUIRE(image.colour.size() == Size{4, 4});
        CHECK(image.alpha.empty());
        CHECK(image.colour.at(3, 3) == glm::vec3(200, 100, 50) / 255.0f);
    }
    // One that is really cut short is still found out.
    CHECK(error_of(file + png_chunk("IDAT", deflated.substr(0, 5)) + end).find("the picture is damaged") !=
          std::string::npos);
}

TEST_CASE("may_have_alpha: told by the header") {
    CHECK(may_have_alpha(png_file({1, 1}, {.colour_type = 6}, "\1\2\3\4")));
    CHECK(may_have_alpha(png_file({1, 1}, {.colour_type = 4}, "\1\2")));
    CHECK_FALSE(may_have_alpha(png_file({1, 1}, {.colour_type = 2}, "\1\2\3")));
    CHECK(may_have_alpha(
        png_file({1, 1}, {.colour_type = 2, .chunks = png_chunk("tRNS", std::string(6, '\0'))}, "\1\2\3")));
    CHECK(may_have_alpha(tga_header(2, {1, 1}, 32, 0x28)));
    CHECK_FALSE(may_have_alpha(tga_header(2, {1, 1}, 32, 0x20)));
    CHECK_FALSE(may_have_alpha("\xff\xd8\xff\xe0"));
    CHECK_FALSE(may_have_alpha(""));
}

TEST_CASE("read_png: the file's own codes, 8 bits or 16, and its alpha") {
    const ImageCodes grey = codes_of(png_file({2, 1}, {.colour_type = 0, .bits = 16}, "\x64\0\x64\xc8"s));
    CHECK(grey.colour.at(0, 0) == glm::vec3(25600.0f / 65535));
    CHECK(grey.colour.at(1, 0) == glm::vec3(25800.0f / 65535));
    CHECK(grey.alpha.empty());
    CHECK_FALSE(grey.linear);
    const ImageCodes rgba =
        codes_of(png_file({1, 1}, {.chunks = png_chunk("gAMA", "\0\1\x86\xa0"s)}, "\1\2\3\4"));
    CHECK(rgba.colour.at(0, 0) == glm::vec3(1, 2, 3) / 255.0f);
    CHECK(rgba.alpha.at(0, 0) == 4.0f / 255);
    CHECK(rgba.linear);
    CHECK_THROWS_WITH_AS(codes_of("GIF89a"), doctest::Contains("a GIF picture"), InputError);
    CHECK_THROWS_WITH_AS(codes_of(grey_jpeg()), doctest::Contains("not a PNG picture (a JPEG picture)"),
                         InputError);
    CHECK_THROWS_WITH_AS(codes_of(tga_header(2, {1, 1}, 24, 0x20) + "abc"),
                         doctest::Contains("not a PNG picture (a TGA picture)"), InputError);
}

TEST_CASE("decode_image: a picture beyond the limit given is refused") {
    const std::string four = png_file({2, 2}, {.colour_type = 0}, "\1\2\3\4");
    CHECK_NOTHROW(decode_image(four, "a.png", TextureEncoding::srgb, 4));
    CHECK_THROWS_WITH_AS(decode_image(four, "a.png", TextureEncoding::srgb, 3),
                         doctest::Contains("out of range (2 x 2)"), InputError);
}

TEST_CASE("decode_image: a JPEG whose Huffman table has more codes than any encoder uses is refused") {
    // The counts of codes by length; tables before the first scan and behind it.
    const auto tables = [](int codes) {
        std::string counts(16, '\0');
        counts[14] = static_cast<char>(codes > 200 ? 200 : codes);
        counts[15] = static_cast<char>(codes > 200 ? codes - 200 : 0);
        return "\xff\xc4" + big_endian_bytes(static_cast<std::uint32_t>(2 + 17 + codes), 2) + '\0' + counts +
               std::string(static_cast<std::size_t>(codes), '\1');
    };
    const std::string scan = "\xff\xda\0\x08\1\1\0\0\x3f\0"s, end = "\xff\xd9", start = "\xff\xd8";
    for (const int codes : {256, 257}) {
        CAPTURE(codes);
        for (const std::string& file :
             {start + tables(codes) + scan + end, start + tables(1) + scan + tables(codes) + end}) {
            CHECK(error_of(file).find("a Huffman table of more than 255 codes") != std::string::npos);
        }
    }
    CHECK(error_of(start + tables(255) + scan + end).find("Huffman") == std::string::npos);
}

TEST_CASE("decode_image: a JPEG that defines no tables is refused") {
    // Size 8 x 8, grey; a scan without any DHT.
    const std::string frame = "\xff\xc0\0\x0b\x08\0\x08\0\x08\1\1\x11\0"s;
    const std::string scan = "\xff\xda\0\x08\1\1\0\0\x3f\0\x3f\x12\x34\x56"s;
    CHECK(error_of("\xff\xd8" + frame + scan + "\xff\xd9")
              .find("the picture is damaged (JPEG, no Huffman table before its first scan)") !=
          std::string::npos);
}

TEST_CASE("decode_image: a JPEG of four channels is read where Adobe's marker says which they are") {
    const auto marker = [](int transform) {
        return "\xff\xee\0\x0e"s + "Adobe" + "\0\x64\0\0\0\0"s + static_cast<char>(transform);
    };
    // Size 8 x 8; a DC and an AC table of one code of one bit each, 0: all coefficients are 0.
    const std::string code = byte_string({1}) + std::string(15, '\0') + byte_string({0});
    const auto file = [&](const std::string& segments) {
        std::string channels, of_scan;
        for (int i = 1; i <= 4; ++i) {
            channels += byte_string({i, 0x11, 0});
            of_scan += byte_string({i, 0});
        }
        return byte_string({0xff, 0xd8}) + segments + byte_string({0xff, 0xdb, 0, 67, 0}) +
               std::string(64, '\1') + byte_string({0xff, 0xc0, 0, 20, 8, 0, 8, 0, 8, 4}) + channels +
               byte_string({0xff, 0xc4, 0, 20, 0x00}) + code + byte_string({0xff, 0xc4, 0, 20, 0x10}) + code +
               byte_string({0xff, 0xda, 0, 14, 4}) + of_scan + byte_string({0, 63, 0, 0, 0xff, 0xd9});
    };
    for (const std::string& unknown : {file({}), file(marker(1)), file("\xff\xee\0\x06"s + "Else")})
        CHECK(error_of(unknown).find("the picture is damaged (JPEG, four channels that it does not name)") !=
              std::string::npos);
    for (const int known : {0, 2}) CHECK(error_of(file(marker(known))) == "no error");
}

TEST_CASE(
    "decode_image: channels of a JPEG called RGB are so where no marker says otherwise, as in libjpeg") {
    const std::string jfif =
        byte_string({0xff, 0xe0, 0, 16}) + "JFIF" + byte_string({0, 1, 2, 0, 0, 1, 0, 1, 0, 0});
    const auto adobe = [](int transform) {
        return "\xff\xee\0\x0e"s + "Adobe" + "\0\x64\0\0\0\0"s + static_cast<char>(transform);
    };
    // 8 x 8; the first channel is 100 above the middle, by a DC code of category 7, the others are the middle.
    const auto colour_of = [](const std::string& segments, const std::string& names) {
        std::string channels, of_scan;
        for (const char name : names) {
            channels += name + byte_string({0x11, 0});
            of_scan += name + byte_string({0});
        }
        const std::string file =
            byte_string({0xff, 0xd8}) + segments + byte_string({0xff, 0xdb, 0, 67, 0}) +
            std::string(64, '\x8') + byte_string({0xff, 0xc0, 0, 17, 8, 0, 8, 0, 8, 3}) + channels +
            byte_string({0xff, 0xc4, 0, 21, 0x00, 1, 1}) + std::string(14, '\0') + byte_string({0, 7}) +
            byte_string({0xff, 0xc4, 0, 20, 0x10, 1}) + std::string(15, '\0') + byte_string({0}) +
            byte_string({0xff, 0xda, 0, 12, 3}) + of_scan + byte_string({0, 63, 0, 0xb2, 0x03, 0xff, 0xd9});
        return 255.0f * decode_image(file, "a.jpg", TextureEncoding::linear).colour.at(3, 3);
    };
    const glm::vec3 red(228, 128, 128), light(228);
    const std::string rgb = "RGB", numbers = "\1\2\3";
    const std::tuple<std::string, std::string, glm::vec3> rows[] = {
        {"", rgb, red},
        {"", numbers, light},
        {"", "rgb", light},
        {jfif, rgb, light},
        {jfif, numbers, light},
        {jfif + adobe(0), numbers, light},
        {adobe(0), rgb, red},
        {adobe(0), numbers, red},
        {adobe(1), rgb, light},
        {adobe(1), numbers, light},
        {jfif + adobe(0), rgb, light},
    };
    for (const auto& row : rows) {
        CAPTURE(std::get<0>(row));
        CAPTURE(std::get<1>(row));
        CHECK(glm::length(colour_of(std::get<0>(row), std::get<1>(row)) - std::get<2>(row)) < 0.01f);
    }
}

TEST_CASE("decode_image: a PNG with far more data than its pixels need is refused before it is inflated") {
    const std::string bomb =
        png_file({1, 1}, {.colour_type = 0, .chunks = png_chunk("IDAT", std::string(1 << 17, '\0'))}, "\1");
    CHECK(error_of(bomb).find("t.png: the picture is damaged (PNG, more data than its pixels need)") == 0);
}

TEST_CASE("decode_image: all 16 bits of a channel count") {
    const std::string grey = png_file({2, 1}, {.colour_type = 0, .bits = 16}, "\x64\0\x64\xc8"s);
    const DecodedImage data = decode_image(grey, "a.png", TextureEncoding::linear);
    CHECK(data.colour.at(0, 0) == glm::vec3(25600.0f / 65535));
    CHECK(data.colour.at(1, 0) == glm::vec3(25800.0f / 65535));
    const DecodedImage light = decode_image(grey, "a.png", TextureEncoding::srgb);
    CHECK(light.colour.at(1, 0).x == linear_from_srgb(25800.0f / 65535));
}
