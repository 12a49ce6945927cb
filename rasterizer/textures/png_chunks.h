// What chunks of a PNG say that its decoder, stb_image, passes over.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace crevice {

// The content of the first chunk of this kind before the pixels; nothing where there is none. Of a PNG that is
// whole (image_intact.h).
std::optional<std::string_view> png_chunk_content(std::string_view png, std::string_view kind);

// The exponent of a gAMA chunk that says something else than sRGB: light is a code, [0, 1], to the power of 1 / gamma
// (PNG specification, 11.3.2.2); 1 where codes are proportional to light. Nothing where the file says sRGB, by this
// chunk or by one that goes before it (sRGB, iCCP), or says none, or what no picture has. Of any file.
std::optional<float> png_gamma(std::string_view bytes);

// Apple's variant of PNG.
bool is_apple_png(std::string_view png);

// Apple's deflate streams have no check sum at their end, and stb_image takes the last few bits before the
// end of the data for a cut: the file with zeros behind them, which no block of the stream reaches.
std::string with_room_behind_deflate(const std::string& apple_png);

// A PNG whose pixels are numbers of colours, completed so that every number has one: stb_image would show stale memory
// for those that the file has no colour for. Now they have `alpha`, which no colour of the file has.
struct WholePalette {
    std::string png;
    std::uint8_t alpha = 0;
};
// Nothing where the palette is full, where there is none, and where its chunks are not in order.
std::optional<WholePalette> with_whole_palette(std::string_view png);

}  // namespace crevice
