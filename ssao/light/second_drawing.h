// The tutorials' second drawing of the scene, for its lights: EQUAL on the depths of the first. Where no two
// fragments can have had the same depth it would find the first drawing's triangles, and is left out.
#pragma once

#include <vector>

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

struct SecondDrawing {
    Image<std::int32_t> triangle;  // as Visibility::triangle; empty: the G-buffer's, everywhere
    // The part of each of the geometry's tiles that was drawn again: around pixels where two fragments may have
    // had the same depth, since LESS keeps the first and EQUAL lights the last. Mostly empty.
    std::vector<PixelRect> drawn;
};

// `gbuffer` was made from this geometry. A G-buffer without triangles, or with run.kept, is drawn again as a whole.
SecondDrawing second_drawing(const ScreenGeometry& geometry, const GBuffer& gbuffer, const Holes& holes,
                             const Run& run);

}  // namespace crevice
