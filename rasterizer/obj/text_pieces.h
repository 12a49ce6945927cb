// A text cut into pieces that can be read on their own.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "rasterizer/base/run.h"

namespace crevice {

struct TextPiece {
    std::string_view text;       // whole logical lines (obj_lines.h)
    std::size_t first_line = 1;  // its number in the whole text, from 1
};

// The pieces of `text`, in their order: all of it, in pieces of `piece_bytes` and what is left of the line in
// which they end. At least one.
std::vector<TextPiece> text_pieces(std::string_view text, std::size_t piece_bytes, const Run& run);

}  // namespace crevice
