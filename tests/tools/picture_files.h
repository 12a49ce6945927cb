// PNG, JPEG and TGA files made byte by byte, of kinds that the project reads and does not write.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "rasterizer/base/image.h"

namespace crevice {

inline std::string big_endian_bytes(std::uint32_t value, int count) {
    std::string bytes;
    for (int shift = 8 * (count - 1); shift >= 0; shift -= 8)
        bytes.push_back(static_cast<char>(value >> shift));
    return bytes;
}

inline std::string png_chunk(const std::string& kind, const std::string& content) {
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : kind + content) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
    }
    return big_endian_bytes(static_cast<std::uint32_t>(content.size()), 4) + kind + content +
           big_endian_bytes(~crc, 4);
}

inline std::string byte_string(std::initializer_list<int> values) {
    std::string bytes;
    for (const int value : values) bytes.push_back(static_cast<char>(value));
    return bytes;
}

// Deflate without compression: one stored block.
inline std::string stored_block(const std::string& content) {
    const auto length = static_cast<std::uint32_t>(content.size());
    const auto little = [](std::uint32_t v) {
        return std::string{static_cast<char>(v & 255), static_cast<char>(v >> 8 & 255)};
    };
    return '\1' + little(length) + little(~length) + content;
}

inline std::string zlib_stream(const std::string& content) {
    std::uint32_t a = 1, b = 0;  // Adler-32
    for (const char byte : content) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return std::string("\x78\x01", 2) + stored_block(content) + big_endian_bytes(b << 16 | a, 4);
}

// What a PNG is made of: 0 grey, 2 RGB, 3 palette, 4 grey with alpha, 6 RGBA; bits a channel; chunks before
// the pixels.
struct PngKind {
    int colour_type = 6, bits = 8;
    std::string chunks = {};
    bool apple = false;  // CgBI: no zlib wrapping; pixels are blue, green, red, alpha, colours times alpha
};

// `samples`: all pixels in rows from the top, each channel of 8 bits, or of 16 with the high byte first.
inline std::string png_file(Size size, const PngKind& kind, const std::string& samples) {
    const std::size_t row_bytes = samples.size() / static_cast<std::size_t>(size.height);
    std::string rows;
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.height); ++y) {
        rows += '\0' + samples.substr(y * row_bytes, row_bytes);
    }
    const std::string header = big_endian_bytes(static_cast<std::uint32_t>(size.width), 4) +
                               big_endian_bytes(static_cast<std::uint32_t>(size.height), 4) +
                               static_cast<char>(kind.bits) + static_cast<char>(kind.colour_type) +
                               std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" +
           (kind.apple ? png_chunk("CgBI", std::string("\x50\0\x20\2", 4)) : std::string()) +
           png_chunk("IHDR", header) + kind.chunks +
           png_chunk("IDAT", kind.apple ? stored_block(rows) : zlib_stream(rows)) + png_chunk("IEND", "");
}

// A baseline JPEG of 8 x 8 grey pixels of value 128: all coefficients are 0, both codes have one bit.
// `segments` stand behind its start marker.
inline std::string grey_jpeg(const std::string& segments = {}) {
    const std::string one_code = byte_string({1}) + std::string(15, '\0') + byte_string({0});
    return byte_string({0xff, 0xd8}) + segments + byte_string({0xff, 0xdb, 0, 67, 0}) +
           std::string(64, '\1') + byte_string({0xff, 0xc0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0}) +
           byte_string({0xff, 0xc4, 0, 20, 0x00}) + one_code + byte_string({0xff, 0xc4, 0, 20, 0x10}) +
           one_code + byte_string({0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0}) + byte_string({0x3f, 0xff, 0xd9});
}

// The segment of a JPEG in which EXIF tells how the camera was held; numbers are big-endian.
inline std::string exif_segment(int orientation) {
    const std::string directory = byte_string({0, 2, 0x01, 0x00, 0, 4, 0, 0, 0, 1, 0, 0, 0, 8}) +
                                  byte_string({0x01, 0x12, 0, 3, 0, 0, 0, 1, 0, orientation, 0, 0}) +
                                  std::string(4, '\0');
    const std::string content = std::string("Exif\0\0MM\0*\0\0\0\x08", 14) + directory;
    return byte_string({0xff, 0xe1}) + big_endian_bytes(static_cast<std::uint32_t>(content.size() + 2), 2) +
           content;
}

// The header of a TGA without palette. `type`: 2 colours, 3 grey, 10 and 11 the same run-length coded. Bits 4
// and 5 of the descriptor: from the right, from the top; bits 0 to 3: alpha bits.
inline std::string tga_header(int type, Size size, int bits, int descriptor) {
    std::string header(18, '\0');
    header[2] = static_cast<char>(type);
    header[12] = static_cast<char>(size.width & 255);
    header[13] = static_cast<char>(size.width >> 8);
    header[14] = static_cast<char>(size.height & 255);
    header[15] = static_cast<char>(size.height >> 8);
    header[16] = static_cast<char>(bits);
    header[17] = static_cast<char>(descriptor);
    return header;
}

// The same with a palette of `entries` colours of `entry_bits`, the first of which has the number `first`.
// `type`: 1, or 9 run-length coded.
inline std::string palette_tga_header(int type, Size size, int bits, int descriptor, int first, int entries,
                                      int entry_bits) {
    std::string header = tga_header(type, size, bits, descriptor);
    header[1] = 1;
    header[3] = static_cast<char>(first);
    header[5] = static_cast<char>(entries);
    header[7] = static_cast<char>(entry_bits);
    return header;
}

}  // namespace crevice
