// TGA pictures: colours, greys and palettes, plain or run-length coded, stored from any of the four corners.
// Source: Truevision TGA file format specification, version 2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "rasterizer/base/image.h"

namespace crevice {

// Four bytes RGBA a pixel, row 0 on top.
struct RgbaPixels {
    Size size;
    std::vector<std::uint8_t> bytes;
    bool has_alpha = false;  // the file has a channel for it; else all alpha is 255
};

// What a TGA's header says, as far as it is believable.
struct TgaHeader {
    bool valid = false;  // false: these bytes are no TGA
    Size size;
    // The fourth byte of a pixel is alpha only where the header counts its bits: many writers leave it 0.
    bool has_alpha = false;
};
TgaHeader tga_header(std::string_view bytes);

// The pixels of a file whose header is valid; empty when it is cut short or an index has no palette entry.
RgbaPixels decode_tga(std::string_view bytes);

}  // namespace crevice
