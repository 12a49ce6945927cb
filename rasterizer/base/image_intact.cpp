#include "rasterizer/base/image_intact.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "rasterizer/base/png_layout.h"

namespace crevice {
namespace {

std::uint32_t byte_at(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]);
}

// The remainders of all bytes for the CRC of ISO 3309, which PNG uses (PNG specification, annex D).
constexpr std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
        std::uint32_t c = n;
        for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
        table[n] = c;
    }
    return table;
}

std::uint32_t crc_of(std::string_view bytes) {
    static constexpr std::array<std::uint32_t, 256> kTable = crc_table();
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) crc = kTable[(crc ^ static_cast<unsigned char>(byte)) & 255u] ^ (crc >> 8);
    return ~crc;
}

std::string damage_in_png(std::string_view bytes) {
    std::size_t at = kPngSignature.size();
    while (bytes.size() - at >= kAroundChunkContent) {
        const std::size_t length = big_endian(bytes, at);
        if (length > bytes.size() - at - kAroundChunkContent) break;
        const std::string_view kind = bytes.substr(at + 4, 4);
        if (crc_of(bytes.substr(at + 4, length + 4)) != big_endian(bytes, at + 8 + length)) {
            return "PNG, wrong check sum at byte " + std::to_string(at);
        }
        if (kind == "IEND") return {};
        at += length + kAroundChunkContent;
    }
    return "PNG, cut short";
}

std::uint32_t byte_or_zero(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? byte_at(bytes, at) : 0;
}

// Whether the Huffman tables of a DHT segment whose length stands at `at` have at most 255 codes each; no
// encoder uses more than about 200. stb_image (2.27) writes behind its own tables from 257 on, and takes the
// 256th for none.
bool huffman_tables_fit(std::string_view bytes, std::size_t at) {
    constexpr std::uint32_t kMostCodes = 255, kLengths = 16;
    const std::size_t end = at + (byte_or_zero(bytes, at) << 8 | byte_or_zero(bytes, at + 1));
    for (at += 2; at < end;) {
        std::uint32_t codes = 0;
        for (std::uint32_t i = 1; i <= kLengths; ++i) codes += byte_or_zero(bytes, at + i);
        if (codes > kMostCodes) return false;
        at += 1 + kLengths + codes;
    }
    return true;
}

// What a frame header (at its length) has of channels; four without Adobe's marker, which says CMYK or YCCK, are
// unknown, and stb_image takes them for YCbCr.
bool names_its_colours(std::string_view bytes, std::size_t frame, std::size_t adobe) {
    constexpr std::size_t kChannels = 7, kTransform = 13, kCmyk = 0, kYcck = 2;
    if (byte_or_zero(bytes, frame + kChannels) != 4) return true;
    if (adobe == 0) return false;
    const std::uint32_t transform = byte_or_zero(bytes, adobe + kTransform);
    return transform == kCmyk || transform == kYcck;
}

bool is_frame_header(std::uint32_t marker) {
    constexpr std::uint32_t kTables = 0xc4, kExtension = 0xc8, kArithmeticTables = 0xcc;
    return marker >= 0xc0 && marker <= 0xcf && marker != kTables && marker != kExtension &&
           marker != kArithmeticTables;
}

// The segments up to the first scan; and behind it, where coded data never look like one, all that look like
// tables.
std::string damage_in_jpeg_tables(std::string_view bytes) {
    constexpr unsigned char kTables = 0xc4, kScan = 0xda, kAdobe = 0xee;
    const std::string too_many = "JPEG, a Huffman table of more than 255 codes";
    bool has_tables = false;
    std::size_t at = 2, frame = 0, adobe = 0;  // 0: there is none
    while (at < bytes.size()) {
        at = bytes.find('\xff', at);
        while (at < bytes.size() && byte_at(bytes, at) == 0xff) ++at;
        if (at >= bytes.size()) break;
        const std::uint32_t marker = byte_at(bytes, at++);
        if (marker == kTables && !huffman_tables_fit(bytes, at)) return too_many;
        if (marker == kScan) break;
        has_tables = has_tables || marker == kTables;
        if (is_frame_header(marker)) frame = at;
        if (marker == kAdobe && bytes.substr(at + 2, 5) == "Adobe") adobe = at;
        at += byte_or_zero(bytes, at) << 8 | byte_or_zero(bytes, at + 1);
    }
    if (!has_tables) return "JPEG, no Huffman table before its first scan";
    if (frame != 0 && !names_its_colours(bytes, frame, adobe))
        return "JPEG, four channels that it does not name";
    for (at = bytes.find("\xff\xc4", at); at != std::string_view::npos; at = bytes.find("\xff\xc4", at + 1)) {
        if (!huffman_tables_fit(bytes, at + 2)) return too_many;
    }
    return {};
}

// An end marker inside the header belongs to a thumbnail, so the last one has to follow the last start of a
// scan.
std::string damage_in_jpeg(std::string_view bytes) {
    const std::size_t scan = bytes.rfind("\xff\xda"), end = bytes.rfind("\xff\xd9");
    const bool whole = scan != std::string_view::npos && end != std::string_view::npos && scan < end;
    return whole ? damage_in_jpeg_tables(bytes) : "JPEG, cut short";
}

}  // namespace

std::string damage_in_image(std::string_view bytes) {
    if (bytes.starts_with(kPngSignature)) return damage_in_png(bytes);
    if (bytes.starts_with("\xff\xd8")) return damage_in_jpeg(bytes);
    return {};
}

std::size_t png_end_chunk(std::string_view bytes) {
    std::size_t at = kPngSignature.size();
    while (bytes.substr(at + 4, 4) != "IEND") at += big_endian(bytes, at) + kAroundChunkContent;
    return at;
}

std::size_t png_pixel_bytes(std::string_view bytes) {
    const std::size_t end = png_end_chunk(bytes);
    std::size_t sum = 0;
    for (std::size_t at = kPngSignature.size(); at < end; at += big_endian(bytes, at) + kAroundChunkContent) {
        if (bytes.substr(at + 4, 4) == "IDAT") sum += big_endian(bytes, at);
    }
    return sum;
}

}  // namespace crevice
