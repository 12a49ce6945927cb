// TIFF files put together as TIFF 6.0, section 2, says.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace crevice {

template <class T>
std::string bytes_of_number(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

struct TiffTag {
    std::uint16_t tag;
    std::uint32_t value;
};

// One strip, little-endian: TIFF 6.0, section 2. `other` tags replace those of the same number.
inline std::string tiff_by_hand(std::uint32_t width, std::uint32_t height, std::uint32_t bits,
                                std::uint32_t samples, std::uint32_t format, const std::string& pixels,
                                const std::vector<TiffTag>& other = {}, std::uint32_t next_picture = 0) {
    std::vector<TiffTag> tags = {{256, width},
                                 {257, height},
                                 {258, bits},
                                 {259, 1},
                                 {262, samples >= 3 ? 2u : 1u},
                                 {273, 0},
                                 {274, 1},
                                 {277, samples},
                                 {278, height},
                                 {279, static_cast<std::uint32_t>(pixels.size())},
                                 {339, format}};
    for (const TiffTag& changed : other) {
        for (TiffTag& tag : tags) {
            if (tag.tag == changed.tag) tag = changed;
        }
    }
    const bool many = samples > 2;  // then these are arrays, behind the directory
    const std::uint32_t end = 8 + 2 + 12 * static_cast<std::uint32_t>(tags.size()) + 4;
    std::string arrays;
    std::string file = std::string("II*\0", 4) + bytes_of_number(std::uint32_t{8}) +
                       bytes_of_number(static_cast<std::uint16_t>(tags.size()));
    for (const TiffTag& tag : tags) {
        const bool each = tag.tag == 258 || tag.tag == 339;
        std::uint32_t value = tag.value;
        if (tag.tag == 273) value = end + (many ? 4 * samples : 0);
        if (each && many) value = end + static_cast<std::uint32_t>(arrays.size());
        if (each && !many && samples == 2) value = tag.value | tag.value << 16;
        if (each && many) {
            for (std::uint32_t s = 0; s < samples; ++s)
                arrays += bytes_of_number(static_cast<std::uint16_t>(tag.value));
        }
        file += bytes_of_number(tag.tag) +
                bytes_of_number(std::uint16_t{each ? std::uint16_t{3} : std::uint16_t{4}}) +
                bytes_of_number(each ? samples : 1u) + bytes_of_number(value);
    }
    return file + bytes_of_number(next_picture) + arrays + pixels;
}

}  // namespace crevice
