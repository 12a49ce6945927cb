// An OpenEXR file put together byte by byte, without the library: what readers are held to, and what they must refuse.
// Source: https://openexr.com, "OpenEXR File Layout"
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "rasterizer/base/image.h"

namespace crevice {

struct HandMadeChannel {
    std::string name;
    int type = 2;  // 0: whole numbers, 1: float16, 2: float32
    int sampling = 1;
    std::vector<std::string> lines = {};  // the bytes of each line, little-endian
};

template <class T>
std::string exr_number(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

inline std::string exr_attribute(const std::string& name, const std::string& type, const std::string& value) {
    return name + '\0' + type + '\0' + exr_number(static_cast<std::int32_t>(value.size())) + value;
}

// Uncompressed lines. Channels must stand in the order of their names. `first`: where the data window begins; `flags` are
// those of the version field; `more` attributes stand at the end of the header.
inline std::string exr_by_hand(Size size, const std::vector<HandMadeChannel>& channels, int first = 0,
                               std::int32_t flags = 0, const std::string& more = "") {
    const auto box = [&](int x, int y) {
        return exr_number(x) + exr_number(y) + exr_number(x + size.width - 1) +
               exr_number(y + size.height - 1);
    };
    std::string list;
    for (const HandMadeChannel& c : channels)
        list += c.name + '\0' + exr_number(c.type) + exr_number(0) + exr_number(c.sampling) +
                exr_number(c.sampling);
    std::string file = exr_number(std::int32_t{20000630}) + exr_number(2 | flags);
    file += exr_attribute("channels", "chlist", list + '\0') +
            exr_attribute("compression", "compression", std::string(1, '\0')) +
            exr_attribute("dataWindow", "box2i", box(first, first)) +
            exr_attribute("displayWindow", "box2i", box(0, 0)) +
            exr_attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
            exr_attribute("pixelAspectRatio", "float", exr_number(1.0f)) +
            exr_attribute("screenWindowCenter", "v2f", exr_number(0.0f) + exr_number(0.0f)) +
            exr_attribute("screenWindowWidth", "float", exr_number(1.0f)) + more + '\0';
    std::vector<std::string> lines;
    for (int y = 0; y < size.height; ++y) {
        std::string values;
        for (const HandMadeChannel& c : channels) {
            if (static_cast<std::size_t>(y) < c.lines.size()) values += c.lines[static_cast<std::size_t>(y)];
        }
        lines.push_back(exr_number(first + y) + exr_number(static_cast<std::int32_t>(values.size())) +
                        values);
    }
    std::uint64_t at = file.size() + 8 * lines.size();
    for (const std::string& line : lines) {
        file += exr_number(at);
        at += line.size();
    }
    for (const std::string& line : lines) file += line;
    return file;
}

}  // namespace crevice
