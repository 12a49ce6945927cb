// What a pass did with each tile of its picture: the record behind the counts of what was left out, and behind
// chapter 23's pictures.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rasterizer/base/image.h"

namespace crevice {

enum class TileWork : std::uint8_t {
    done,        // computed
    background,  // no surface: left at the clear value
    open,        // accessibility is exactly 1: left at 1
    lit_once,    // of the lit pass: lit from what the first pass kept, not drawn again
};

struct TileMap {
    Size picture;     // of the pass, pixels
    int tile_px = 0;  // side of a tile
    Image<TileWork> tiles;

    TileMap() = default;
    TileMap(Size size, int side)
        : picture(size),
          tile_px(side),
          tiles({(size.width + side - 1) / side, (size.height + side - 1) / side}, TileWork::done) {}

    std::size_t count() const {
        return static_cast<std::size_t>(tiles.size.width) * static_cast<std::size_t>(tiles.size.height);
    }
    std::size_t count(TileWork work) const {
        std::size_t total = 0;
        for (int y = 0; y < tiles.size.height; ++y) {
            for (int x = 0; x < tiles.size.width; ++x) total += tiles.at(x, y) == work ? 1 : 0;
        }
        return total;
    }
};

}  // namespace crevice
