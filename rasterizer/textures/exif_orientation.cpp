#include "rasterizer/textures/exif_orientation.h"

#include <cstddef>
#include <cstdint>

namespace crevice {
namespace {

using namespace std::string_view_literals;

// The unsigned number of `count` bytes at `at`; 0 behind the end.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t count, bool little_endian) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = at + (little_endian ? count - 1 - i : i);
        value = value << 8 | (place < bytes.size() ? static_cast<unsigned char>(bytes[place]) : 0u);
    }
    return value;
}

// In the TIFF header that an EXIF segment holds: its first directory has entries of tag, type, count and
// value.
int orientation_in_tiff(std::string_view tiff) {
    constexpr std::uint32_t kOrientation = 0x0112, kShort = 3;
    constexpr std::size_t kEntryBytes = 12;
    const bool little = tiff.starts_with("II*\0"sv);
    if (!little && !tiff.starts_with("MM\0*"sv)) return 1;
    const std::size_t directory = number_at(tiff, 4, 4, little);
    const std::size_t entries = number_at(tiff, directory, 2, little);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + i * kEntryBytes;
        if (number_at(tiff, entry, 2, little) != kOrientation ||
            number_at(tiff, entry + 2, 2, little) != kShort)
            continue;
        const std::uint32_t value = number_at(tiff, entry + 8, 2, little);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

}  // namespace

int exif_orientation(std::string_view jpeg) {
    constexpr char kMarker = '\xff', kApp1 = '\xe1', kScan = '\xda';
    constexpr std::string_view kExif = "Exif\0\0"sv;
    // Behind the start marker stand segments of a marker, the length of what follows it, and that.
    for (std::size_t at = 2; at + 4 <= jpeg.size() && jpeg[at] == kMarker && jpeg[at + 1] != kScan;) {
        const std::size_t length = number_at(jpeg, at + 2, 2, false);
        const std::string_view segment = jpeg.substr(at + 4, length < 2 ? 0 : length - 2);
        if (jpeg[at + 1] == kApp1 && segment.starts_with(kExif)) {
            return orientation_in_tiff(segment.substr(kExif.size()));
        }
        at += 2 + length;
    }
    return 1;
}

}  // namespace crevice
