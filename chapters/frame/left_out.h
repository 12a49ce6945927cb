// What a frame left out, in counts and as maps of its tiles, and the time that saved.
#pragma once

#include <vector>

#include "chapters/frame/kept_passes.h"
#include "rasterizer/base/leave_out.h"
#include "rasterizer/base/tile_map.h"
#include "rasterizer/draw/normal_depth.h"

namespace crevice {

// What each pass did with its tiles when it ran, in this frame or in the one before that it was kept from; without tiles where
// neither ran it.
struct FrameTiles {
    TileMap raster, ao, blur, lit;
};

struct SkippedWork {
    Skip skip;
    std::size_t count = 0, of = 0;  // triangles, entries of tiles' lists, or tiles
    const char* unit = "";
};

// One entry a kind that can be counted, those with count 0 too. `passes` is not among them: its reasons are
// Needs::left_out; nor are faint highlights, which are left out eight pixels here and there. A pass that was kept did
// nothing in this frame, so it counts 0 of 0.
std::vector<SkippedWork> skipped_work(const ScreenGeometry& geometry, const GBuffer& gbuffer,
                                      const FrameTiles& tiles, const KeptPasses& kept = {});

// The tiles of the first pass: background where no triangle is.
TileMap raster_tiles(const ScreenGeometry& geometry, const Run& run);

}  // namespace crevice
