#include "rasterizer/draw/visibility.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

#include "rasterizer/base/parallel.h"
#include "rasterizer/draw/tile_raster.h"

namespace crevice {

namespace {

// Asks for the cache lines of the tile to the right, which is probably cleared next: they come while this one is drawn.
CREVICE_INLINE void expect_tile_after(const Drawing& drawing, PixelRect part) {
    const int end = std::min(part.x1 + drawing.geometry.tile_size, drawing.geometry.size.width);
    for (Image<std::int32_t>* const image : {drawing.depth, drawing.triangle}) {
        if (image == nullptr) continue;
        for (int y = part.y0; y < part.y1; ++y) expect_row(*image, part.x1, end, y);
    }
}

TileRecord draw_tile(const Drawing& drawing, int tile, PixelRect part, const Run& run) {
    if (drawing.clear_code) fill(*drawing.depth, part, *drawing.clear_code);
    if (drawing.triangle != nullptr) fill(*drawing.triangle, part, kNoTriangle);
    expect_tile_after(drawing, part);
    TileRecord record;
    record.triangles = drawing.geometry.triangles_of_tile(tile);
    if (record.triangles == 0 && run.leaves_out(Skip::empty_tiles)) return record;
    run_kernel(run, [&]<class F>(Lanes<F>) {
        TileRaster<F> raster{drawing, part};
        raster.draw_all(tile, run);
        record.hidden = raster.record.hidden;
        record.tied = raster.record.tied;
    });
    return record;
}

std::vector<TileRecord> draw_tiles(const Drawing& drawing, const PixelRect* parts, const Run& run,
                                   const std::function<void(int tile_row)>& when_drawn = {}) {
    const ScreenGeometry& geometry = drawing.geometry;
    std::vector<TileRecord> records(static_cast<std::size_t>(geometry.tile_count()));
    // Of each row of tiles, how many are not drawn yet.
    std::vector<std::atomic<int>> left(static_cast<std::size_t>(geometry.tiles.height));
    for (std::atomic<int>& tiles : left) tiles = geometry.tiles.width;
    parallel_for(geometry.tile_count(), run, [&](int tile) {
        const PixelRect part = parts == nullptr ? geometry.tile_rect(tile) : parts[tile];
        if (!part.empty()) records[static_cast<std::size_t>(tile)] = draw_tile(drawing, tile, part, run);
        const int row = tile / geometry.tiles.width;
        if (--left[static_cast<std::size_t>(row)] == 0 && when_drawn) when_drawn(row);
    });
    return records;
}

}  // namespace

DepthFunction nearest_wins(bool reversed_z) {
    return reversed_z ? DepthFunction::greater : DepthFunction::less;
}

Visibility visibility(const ScreenGeometry& geometry, DepthFormat format, bool reversed_z, const Holes& holes,
                      const Run& run, const WhenDrawn& when_drawn) {
    Visibility seen{{format, Image<std::int32_t>(geometry.size)}, Image<std::int32_t>(geometry.size), {}};
    Image<std::int32_t>& codes = seen.depth.codes;
    seen.tiles = draw_tiles({geometry, nearest_wins(reversed_z), format, codes, &codes,
                             depth_code(format, reversed_z ? 0.0f : 1.0f, 0.0), &seen.triangle, holes},
                            nullptr, run, [&](int tile_row) {
                                const int first = tile_row * geometry.tile_size;
                                if (when_drawn)
                                    when_drawn(seen, first,
                                               std::min(first + geometry.tile_size, geometry.size.height));
                            });
    return seen;
}

std::vector<std::int32_t> hidden_triangles(const ScreenGeometry& geometry, DepthFormat format,
                                           bool reversed_z, int tile, const Holes& holes, const Run& run) {
    Image<std::int32_t> codes(geometry.size);
    std::vector<std::int32_t> hidden;
    draw_tile({geometry, nearest_wins(reversed_z), format, codes, &codes,
               depth_code(format, reversed_z ? 0.0f : 1.0f, 0.0), nullptr, holes, &hidden},
              tile, geometry.tile_rect(tile), run);
    return hidden;
}

Visibility drawn_over(DepthBuffer depth, const ScreenGeometry& geometry, DepthFunction test,
                      const Holes& holes, const Run& run) {
    Visibility seen{std::move(depth), Image<std::int32_t>(geometry.size), {}};
    Image<std::int32_t>& codes = seen.depth.codes;
    seen.tiles =
        draw_tiles({geometry, test, seen.depth.format, codes, &codes, std::nullopt, &seen.triangle, holes},
                   nullptr, run);
    return seen;
}

Image<std::int32_t> drawn_again(const ScreenGeometry& geometry, const DepthBuffer& depth, DepthFunction test,
                                const Holes& holes, const Run& run) {
    Image<std::int32_t> triangle(geometry.size);
    draw_tiles({geometry, test, depth.format, depth.codes, nullptr, std::nullopt, &triangle, holes}, nullptr,
               run);
    return triangle;
}

Image<std::int32_t> drawn_again(Image<std::int32_t> triangle, std::span<const PixelRect> parts,
                                const ScreenGeometry& geometry, const DepthBuffer& depth, DepthFunction test,
                                const Holes& holes, const Run& run) {
    draw_tiles({geometry, test, depth.format, depth.codes, nullptr, std::nullopt, &triangle, holes},
               parts.data(), run);
    return triangle;
}

DepthBuffer nearest_depth(const ScreenGeometry& geometry, DepthFormat format, const Holes& holes,
                          const Run& run) {
    DepthBuffer depth{format, Image<std::int32_t>(geometry.size)};
    draw_tiles({geometry, DepthFunction::less, format, depth.codes, &depth.codes,
                depth_code(format, 1.0f, 0.0), nullptr, holes},
               nullptr, run);
    return depth;
}

}  // namespace crevice
