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
                                      const FrameTiles& tiles, const KeptPasses& kept) {
    const ScreenGeometry no_geometry;
    const ScreenGeometry& drawn = kept.normal_depth ? no_geometry : geometry;
    std::size_t hidden = 0, entries = 0;
    if (!kept.normal_depth) {
        for (const TileRecord& record : gbuffer.tiles) {
            hidden += record.hidden;
            entries += record.triangles;
        }
    }
    const TileMap no_tiles;
    const TileMap &raster = kept.normal_depth ? no_tiles : tiles.raster, &ao = kept.ao ? no_tiles : tiles.ao,
                  &blur = kept.blur ? no_tiles : tiles.blur, &lit = kept.lit ? no_tiles : tiles.lit;
    const auto counted = [](Skip skip, std::size_t count, std::size_t of, const char* unit) {
        return SkippedWork{skip, count, of, unit};
    };
    return {
        counted(Skip::off_screen_clusters, drawn.off_screen_clusters, drawn.clusters, "clusters"),
        counted(Skip::off_screen_triangles, drawn.off_screen_triangles(), drawn.submitted_triangles,
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
