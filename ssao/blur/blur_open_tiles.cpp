// Which tiles of an AO map the blur cannot change.
#include <algorithm>

#include "rasterizer/base/pixel_rect.h"
#include "rasterizer/base/run.h"
#include "ssao/blur/bilateral_blur.h"

namespace crevice {

namespace {

PixelRect tile_rectangle(int column, int row) {
    return {column * kBlurTile, row * kBlurTile, (column + 1) * kBlurTile, (row + 1) * kBlurTile};
}

bool all_one(const Image<float>& ao, const PixelRect& texels) {
    for (int y = texels.y0; y < texels.y1; ++y) {
        const float* row = ao.row(y);
        if (!std::all_of(row + texels.x0, row + texels.x1, [](float a) { return a == 1; })) return false;
    }
    return true;
}

// For each tile whether all of its texels are 1. A tile outside the map holds none that is not.
class OneTiles {
 public:
    // On one thread: where much is dark it looks at few texels, and waking threads would take longer.
    OneTiles(const Image<float>& ao, Size count, const Run& run) : one_(count, false) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int row = 0; row < count.height; ++row) {
                for (int column = 0; column < count.width; ++column)
                    one_.at(column, row) = tile_is_one<F>(ao, column, row);
            }
        });
    }

    bool at(int column, int row) const {
        const Size count = one_.size;
        return column < 0 || row < 0 || column >= count.width || row >= count.height || one_.at(column, row);
    }

 private:
    template <class F>
    CREVICE_INLINE static bool tile_is_one(const Image<float>& ao, int column, int row) {
        const PixelRect tile =
            common_part(tile_rectangle(column, row), {0, 0, ao.size.width, ao.size.height});
        const int whole_groups = tile.x0 + (tile.x1 - tile.x0) / kLanes<F> * kLanes<F>;
        for (int y = tile.y0; y < tile.y1; ++y) {
            const float* texels = ao.row(y);
            for (int x = tile.x0; x < whole_groups; x += kLanes<F>) {
                if (any(load<F>(texels + x) != F(1))) return false;
            }
        }
        return all_one(ao, {whole_groups, tile.y0, tile.x1, tile.y1});
    }

    Image<unsigned char> one_;
};

// Whether the tiles at a distance of up to `reach` tiles are one as well. Separable: `along` the rows first.
Image<unsigned char> surrounded(const OneTiles& one, Size count, int reach) {
    Image<unsigned char> along(count, 0), result(count, 0);
    for (int row = 0; row < count.height; ++row) {
        for (int column = 0; column < count.width; ++column) {
            bool holds = true;
            for (int c = column - reach; holds && c <= column + reach; ++c) holds = one.at(c, row);
            along.at(column, row) = holds;
        }
    }
    for (int row = 0; row < count.height; ++row) {
        const int first = std::max(0, row - reach), last = std::min(count.height - 1, row + reach);
        for (int column = 0; column < count.width; ++column) {
            bool holds = true;
            for (int r = first; holds && r <= last; ++r) holds = along.at(column, r) != 0;
            result.at(column, row) = holds;
        }
    }
    return result;
}

// The ring of tiles that a reach of so many texels enters and does not cross: is all it enters 1?
bool ring_is_one(const Image<float>& ao, const OneTiles& one, int column, int row, int reach_px) {
    const PixelRect map = {0, 0, ao.size.width, ao.size.height}, tile = tile_rectangle(column, row);
    const PixelRect read =
        common_part({tile.x0 - reach_px, tile.y0 - reach_px, tile.x1 + reach_px, tile.y1 + reach_px}, map);
    const int distance = reach_px / kBlurTile + 1;
    for (int r = row - distance; r <= row + distance; ++r) {
        const bool whole_row = r == row - distance || r == row + distance;
        for (int c = column - distance; c <= column + distance; c += whole_row ? 1 : 2 * distance) {
            if (!one.at(c, r) && !all_one(ao, common_part(tile_rectangle(c, r), read))) return false;
        }
    }
    return true;
}

}  // namespace

TileMap open_blur_tiles(const Image<float>& ao, const BlurSettings& settings, const Run& run) {
    validate(settings);
    TileMap map(ao.size, kBlurTile);
    const Size count = map.tiles.size;
    const int reach_px = settings.iterations * kBlurRadius;
    const OneTiles one(ao, count, run);
    const Image<unsigned char> candidates = surrounded(one, count, reach_px / kBlurTile);
    for (int row = 0; row < count.height; ++row) {
        for (int column = 0; column < count.width; ++column) {
            if (candidates.at(column, row) && ring_is_one(ao, one, column, row, reach_px))
                map.tiles.at(column, row) = TileWork::open;
        }
    }
    return map;
}

}  // namespace crevice
