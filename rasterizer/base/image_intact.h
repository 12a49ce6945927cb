// Damage that an image decoder would pass over: a picture cut short or altered decodes to garbage or to stale
// memory.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace crevice {

// What is wrong with the bytes of a PNG (chunk lengths and check sums) or JPEG (end marker, Huffman
// tables, four channels without a word which colours they are) file, or nothing ("") when it is whole, or of another kind.
std::string damage_in_image(std::string_view bytes);

// Where the IEND chunk of a PNG that is whole begins.
std::size_t png_end_chunk(std::string_view bytes);

// How many bytes of coded pixels a PNG that is whole has in its IDAT chunks.
std::size_t png_pixel_bytes(std::string_view bytes);

}  // namespace crevice
