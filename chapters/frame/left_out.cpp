#include "chapters/frame/left_out.h"

namespace crevice {

TileMap raster_tiles(const ScreenGeometry& geometry, const Run& run) {
    TileMap map(geometry.size, geometry.tile_size);
    for (int tile = 0; tile < geometry.tile_count(); ++tile) {
        if (geometry.triangles_of_tile(tile) > 0 || !run.leaves_out(Skip::empty_tiles)) continue;
        map.tiles.at(tile % geometry.tiles.width, tile / geometry.tiles.width) = TileWork::background;
    }
    return map;
}

std::vector<SkippedWork> skipped_work(const ScreenGeometry& geometry, const GBuffer& gbuffer,
                                      const FrameTiles& tiles) {
    std::size_t hidden = 0, entries = 0;
    for (const TileRecord& record : gbuffer.tiles) {
        hidden += record.hidden;
        entries += record.triangles;
    }
    const auto counted = [](Skip skip, std::size_t count, std::size_t of, const char* unit) {
        return SkippedWork{skip, count, of, unit};
    };
    const TileMap &raster = tiles.raster, &ao = tiles.ao, &blur = tiles.blur, &lit = tiles.lit;
    return {
        counted(Skip::off_screen_clusters, geometry.off_screen_clusters, geometry.clusters, "clusters"),
        counted(Skip::off_screen_triangles, geometry.off_screen_triangles(), geometry.submitted_triangles,
                "triangles"),
        counted(Skip::hidden_triangles, hidden, entries, "triangles of tiles"),
        counted(Skip::empty_tiles, raster.count(TileWork::background), raster.count(), "tiles"),
        counted(Skip::background_pixels, ao.count(TileWork::background), ao.count(), "tiles of the AO map"),
        counted(Skip::open_tiles, ao.count(TileWork::open) + blur.count(TileWork::open),
                ao.count() + blur.count(), "tiles of the AO map and its blur"),
        counted(Skip::second_drawing, lit.count(TileWork::lit_once), lit.count(), "tiles"),
    };
}

}  // namespace crevice
