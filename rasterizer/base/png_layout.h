// How a PNG file is laid out (PNG specification, 5): a signature, then chunks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace crevice {

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

// Bytes around the content of a chunk: before it its length and kind, behind it its check sum.
inline constexpr std::size_t kBeforeChunkContent = 8, kBehindChunkContent = 4,
                             kAroundChunkContent = kBeforeChunkContent + kBehindChunkContent;

// The number that four bytes are, the highest first. `at` + 3 must be within the bytes.
inline std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

}  // namespace crevice
