// The first pass at one pixel: every triangle that reaches into it, in submission order, and what the raster made of
// it. For who asks why a pixel shows what it shows; the numbers are the set-up's and the raster's own.
// In:     a scene, its camera; the geometry of a view and the settings that both passes of it were given
// Out:    PixelFragments; the depth code that is left is the one in the G-buffer
// Cost:   a second set-up of the scene, with its back faces, and the drawing of one tile
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

enum class FragmentVerdict {
    kept,         // passed the depth test, and is what the pixel shows
    drawn_over,   // passed, and a later one passed, too
    behind,       // the stored depth is nearer
    equal,        // the stored depth is the same: the first one stays
    outside,      // the pixel's centre lies beyond an edge, or on one that is neither top nor left
    facing_away,  // a back face of a scene that culls them: never set up
    cut_out,      // its texture has a hole there
    hidden,       // all that was drawn around there is nearer: left out as a whole, with no pixel looked at
};

// A triangle, or a piece that clipping left of one, whose snapped outline reaches into the pixel's square. Those that hold
// no pixel's centre in their bounding box, or are tiny and cover none, are not set up, and not among them.
struct PixelFragment {
    ScreenTriangle triangle;
    std::int32_t number = kNoTriangle;  // ScreenGeometry::triangle(); none for what faces away
    std::int64_t mesh_triangle = -1;    // which of its instance's mesh
    // E_i at the pixel's centre, in 1/256 x 1/256 pixel; inside where > 0.
    std::array<std::int64_t, 3> edge{};
    std::array<bool, 3> top_or_left{};  // which edges own the centres that lie on them
    int outside_edge = -1;    // the first edge that the centre lies beyond; -1: the centre is covered
    float z_ndc = 0;          // of the plane at the centre, without the bias; where covered, as the next two
    std::int32_t code = 0;    // as the buffer's format has it, bias included
    std::int32_t stored = 0;  // the code that was there before
    FragmentVerdict verdict = FragmentVerdict::outside;
};

struct PixelFragments {
    std::int32_t cleared = 0;  // depth code before the first triangle
    std::vector<PixelFragment> fragments;
    std::int32_t code = 0;             // that is left
    std::int32_t shown = kNoTriangle;  // number of the triangle that is seen
};

// `geometry` was made of the scene, this camera and geometry_settings(settings). (x, y) lies in the picture.
PixelFragments pixel_fragments(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
                               const NormalDepthSettings& settings, int x, int y, const Run& run = {});

}  // namespace crevice
