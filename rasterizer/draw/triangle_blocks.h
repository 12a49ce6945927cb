// Set-up and binning of a run of triangles: the middle of screen_geometry.
#pragma once

#include "rasterizer/draw/exact_clip.h"
#include "rasterizer/draw/screen_geometry.h"

namespace crevice {

struct BlockSource {
    std::span<const std::array<std::uint32_t, 3>> triangles;  // of the mesh, from this block on
    std::uint32_t first_vertex, instance;
    std::int32_t material;
    bool mirrored;           // the instance's matrix turns clockwise into counter-clockwise: undone here
    const ExactClip* exact;  // null: the clip positions of TransformedVertices are all there is
};

// Sets up the triangles of sources, clipped where they must be, and enters them into the tiles they may touch.
// `geometry` holds its sizes and vertices already.
TriangleBlock build_block(const ScreenGeometry& geometry, std::span<const BlockSource> sources,
                          const SetupSettings& setup, const Run& run);

}  // namespace crevice
