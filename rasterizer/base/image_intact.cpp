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

}  // namespace

std::string damage_in_image(std::string_view bytes) {
    if (bytes.starts_with(kPngSignature)) return damage_in_png(bytes);
    if (bytes.starts_with("\xff\xd8")) return damage_in_jpeg(bytes);
    return {};
}

}  // namespace crevice
