// Rectangles into a square, shelf by shelf.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "rasterizer/base/image.h"

namespace crevice {

// Where the upper left corner of each rectangle goes in a square of `side`, with at least `gap` between any
// two; nothing when they do not fit. The tallest first, side by side on a shelf as long as there is room,
// then a new shelf below; equal ones in the order given. Sizes and results in texels.
std::optional<std::vector<glm::ivec2>> pack_shelves(std::span<const Size> rectangles, int side, int gap);

}  // namespace crevice
