#include "rasterizer/base/image_intact.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace crevice {
namespace {

std::uint32_t byte_at(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]);
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | byte_at(bytes, at + i);
    return value;
}

std::uint32_t little_endian_16(std::string_view bytes, std::size_t at) {
    return byte_at(bytes, at) | byte_at(bytes, at + 1) << 8;
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

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

std::string damage_in_png(std::string_view bytes) {
    std::size_t at = kPngSignature.size();
    while (bytes.size() - at >= 12) {
        const std::size_t length = big_endian(bytes, at);
        if (length > bytes.size() - at - 12) break;
        const std::string_view kind = bytes.substr(at + 4, 4);
        if (crc_of(bytes.substr(at + 4, length + 4)) != big_endian(bytes, at + 8 + length)) {
            return "PNG, wrong check sum at byte " + std::to_string(at);
        }
        if (kind == "IEND") return {};
        at += length + 12;
    }
    return "PNG, cut short";
}

// An end marker inside the header belongs to a thumbnail, so the last one has to follow the last start of a
// scan.
std::string damage_in_jpeg(std::string_view bytes) {
    const std::size_t scan = bytes.rfind("\xff\xda"), end = bytes.rfind("\xff\xd9");
    const bool whole = scan != std::string_view::npos && end != std::string_view::npos && scan < end;
    return whole ? "" : "JPEG, cut short";
}

// Walks the packets of a run-length coded TGA; true when they cover all pixels.
bool covers_pixels(std::string_view packets, std::size_t pixel_bytes, std::size_t pixels) {
    std::size_t at = 0;
    while (pixels > 0) {
        if (at >= packets.size()) return false;
        const std::uint32_t head = byte_at(packets, at);
        const std::size_t run = (head & 127u) + 1;
        at += 1 + ((head & 128u) != 0 ? 1 : run) * pixel_bytes;
        pixels -= run < pixels ? run : pixels;
    }
    return at <= packets.size();
}

std::string damage_in_tga(std::string_view bytes) {
    constexpr std::size_t kHeader = 18;
    constexpr std::uint32_t kRunLengthCoded = 8;
    if (bytes.size() < kHeader) return "neither PNG nor JPEG nor TGA";
    const std::size_t map_entries = byte_at(bytes, 1) != 0 ? little_endian_16(bytes, 5) : 0;
    const std::size_t map_bytes = map_entries * ((byte_at(bytes, 7) + 7) / 8);
    const std::size_t first = kHeader + byte_at(bytes, 0) + map_bytes;
    const std::size_t pixels = std::size_t{little_endian_16(bytes, 12)} * little_endian_16(bytes, 14);
    const std::size_t pixel_bytes = (byte_at(bytes, 16) + 7) / 8;
    const bool coded = (byte_at(bytes, 2) & kRunLengthCoded) != 0;
    const bool whole =
        first <= bytes.size() && (coded ? covers_pixels(bytes.substr(first), pixel_bytes, pixels)
                                        : pixels * pixel_bytes <= bytes.size() - first);
    return whole ? "" : "TGA, cut short";
}

}  // namespace

std::string damage_in_image(std::string_view bytes) {
    if (bytes.starts_with(kPngSignature)) return damage_in_png(bytes);
    if (bytes.starts_with("\xff\xd8")) return damage_in_jpeg(bytes);
    return damage_in_tga(bytes);
}

}  // namespace crevice
