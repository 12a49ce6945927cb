// A drawing of set-up triangles: what is drawn, how depths are compared, and where the results go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rasterizer/draw/visibility.h"

namespace crevice {

// What is drawn, and where to.
struct Drawing {
    const ScreenGeometry& geometry;
    DepthFunction test;
    DepthFormat format;
    const Image<std::int32_t>& tested;       // depth codes
    Image<std::int32_t>* depth;              // the same, to be written; null: they stay
    std::optional<std::int32_t> clear_code;  // of tiles before their first triangle; none: depths are kept
    Image<std::int32_t>* triangle;           // to be written; null: not asked for
    const Holes& holes;
    // Numbers of what is left out as a whole; null: not asked for.
    std::vector<std::int32_t>* hidden = nullptr;
};

// The pixels that a drawing reads and writes, its pictures being of one size. Copied out of them: what is read through a
// reference is read again after every store.
struct DrawnPixels {
    const std::int32_t* tested;
    std::int32_t *depth, *triangle;  // may be null, as in Drawing
    std::ptrdiff_t stride;

    explicit DrawnPixels(const Drawing& drawing)
        : tested(drawing.tested.row(0)),
          depth(drawing.depth == nullptr ? nullptr : drawing.depth->row(0)),
          triangle(drawing.triangle == nullptr ? nullptr : drawing.triangle->row(0)),
          stride(drawing.tested.stride) {}
    CREVICE_INLINE std::ptrdiff_t at(int x, int y) const { return y * stride + x; }
};

}  // namespace crevice
