#include "ssao/methods/each_texel.h"

#include <algorithm>

namespace crevice {

TileMap surface_tiles(const AoInputs& inputs, const Run& run) {
    TileMap map(inputs.size(), kTexelTile);
    if (!run.leaves_out(Skip::background_pixels)) return map;
    const auto shows_surface = [&](int column, int row) {
        const int left = column * kTexelTile, top = row * kTexelTile;
        const int right = std::min(left + kTexelTile, map.picture.width),
                  bottom = std::min(top + kTexelTile, map.picture.height);
        for (int y = top; y < bottom; ++y) {
            const float* const z = inputs.view_depth.row(y);
            if (std::any_of(z + left, z + right,
                            [](float at) { return at < std::numeric_limits<float>::infinity(); }))
                return true;
        }
        return false;
    };
    parallel_for(map.tiles.size.height, run, [&](int row) {
        for (int column = 0; column < map.tiles.size.width; ++column) {
            if (!shows_surface(column, row)) map.tiles.at(column, row) = TileWork::background;
        }
    });
    return map;
}

const char* verdict_of(const ExplainedSample& sample) {
    if (sample.contribution > 0) return "occludes";
    if (sample.weight == 0) return "too far away";
    if (!(sample.dp > 0)) return "below the surface";
    return "nothing in front";
}

}  // namespace crevice
