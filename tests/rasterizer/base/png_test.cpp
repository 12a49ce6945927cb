#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/image_io.h"
#include "rasterizer/textures/texture.h"
#include "tests/tools/noise.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<std::uint8_t>(bytes[i]);
    return number;
}

// Bit by bit, as appendix D of the PNG specification defines it.
std::uint32_t crc_32(std::string_view bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) {
        crc ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

// Byte by byte, as RFC 1950 defines it.
std::uint32_t adler_32(const Bytes& bytes) {
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

// What lies in the chunks IDAT, all of whose check sums must be right.
std::string zlib_stream(std::string_view png) {
    std::string stream;
    for (std::size_t at = 8; at < png.size();) {
        const std::size_t size = big_endian(png.substr(at));
        const std::string_view type = png.substr(at + 4, 4);
        CAPTURE(at);
        CHECK(big_endian(png.substr(at + 8 + size)) == crc_32(png.substr(at + 4, 4 + size)));
        if (type == "IDAT") stream += png.substr(at + 8, size);
        at += 12 + size;
    }
    return stream;
}

// The rows with the filter Sub, in the words of the specification.
Bytes filtered(Size size, int channels, const Bytes& pixels) {
    const int row_bytes = size.width * channels;
    Bytes rows;
    for (int y = 0; y < size.height; ++y) {
        rows.push_back(1);
        for (int i = 0; i < row_bytes; ++i) {
            const auto at = static_cast<std::size_t>(y * row_bytes + i);
            const int left = i < channels ? 0 : pixels[at - static_cast<std::size_t>(channels)];
            rows.push_back(static_cast<std::uint8_t>(pixels[at] - left));
        }
    }
    return rows;
}

// Written, read again by another library, and the same.
void check_round_trip(Size size, int channels, const Bytes& pixels) {
    CAPTURE(size.width);
    CAPTURE(size.height);
    CAPTURE(channels);
    const ScratchDirectory scratch;
    const std::string png = png_bytes(size, channels, pixels, {.threads = 1});
    CHECK(png == png_bytes(size, channels, pixels, {.threads = 2}));
    const std::string stream = zlib_stream(png);
    CHECK(big_endian(std::string_view(stream).substr(stream.size() - 4)) ==
          adler_32(filtered(size, channels, pixels)));
    write_file_atomically(scratch / "a.png", png);
    const Image3 read = read_png(scratch / "a.png").colour;
    REQUIRE(read.size() == size);
    const Image<float>* const planes[] = {&read.x, &read.y, &read.z};
    int wrong = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const auto at =
                    static_cast<std::size_t>((y * size.width + x) * channels + (channels == 3 ? c : 0));
                if (planes[c]->at(x, y) == static_cast<float>(pixels[at]) / 255) continue;
                if (++wrong == 1) FAIL_CHECK("pixel " << x << ", " << y << ", channel " << c);
            }
        }
    }
    CHECK(wrong == 0);
}

template <class ValueAt>
Bytes painted(Size size, int channels, const ValueAt& value_at) {
    Bytes pixels;
    for (int y = 0; y < size.height; ++y) {
        for (int i = 0; i < size.width * channels; ++i)
            pixels.push_back(static_cast<std::uint8_t>(value_at(i, y)));
    }
    return pixels;
}

}  // namespace

TEST_CASE("png: pictures of every kind are read again as they were, and their check sums are right") {
    const auto noisy = [](int i, int y) { return 256 * noise(1, i, y); };
    const auto flat = [](int, int) { return 77; };
    const auto slope = [](int i, int y) { return i / 3 + 2 * y; };
    const auto few = [](int i, int y) { return noise(3, i, y) < 0.97f ? 0 : 255; };
    for (const int channels : {1, 3}) {
        for (const Size size : {Size{1, 1}, Size{2, 5}, Size{1, 300}, Size{700, 1}, Size{301, 257}}) {
            check_round_trip(size, channels, painted(size, channels, noisy));
            check_round_trip(size, channels, painted(size, channels, flat));
            check_round_trip(size, channels, painted(size, channels, slope));
            check_round_trip(size, channels, painted(size, channels, few));
        }
    }
    // Patterns that come again just within the reach of a match, at its end and beyond; strips that end within a row.
    for (const int period : {32767, 32768, 32769}) {
        const auto far_again = [period](int i, int y) { return 256 * noise(2, i % period, y); };
        check_round_trip({kMaxTextureSide, 3}, 3, painted({kMaxTextureSide, 3}, 3, far_again));
    }
}

TEST_CASE("png: a flat picture is small, and noise hardly larger than its bytes") {
    const Size size{512, 512};
    // At most a match for each 258 bytes (RFC 1951: the longest), which stb's own compressor, where zlib is missing, writes in
    // fixed codes: 8 bits for this length, 5 for the distance and up to 13 behind those.
    constexpr std::size_t kBytes = std::size_t{512} * (1 + 512 * 3), kMatches = kBytes / 258 + 1;
    CHECK(png_bytes(size, 3, painted(size, 3, [](int, int) { return 9; })).size() < kMatches * 26 / 8);
    const std::size_t noise_bytes =
        png_bytes(size, 3, painted(size, 3, [](int i, int y) { return 256 * noise(4, i, y); })).size();
    // stb's own compressor, where zlib is missing, knows no uncompressed blocks.
    CHECK(noise_bytes < 1.1 * 512 * 512 * 3);
}
