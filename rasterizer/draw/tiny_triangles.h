// Triangles of a few pixels. Drawn group by group, most lanes of a group would lie beside them, and most of the time
// would go to setting up their edges. So the set-up, which has a triangle in every lane, finds the pixels that they cover:
// those that cover none go no further (of a finely tessellated mesh a third), of the others the raster takes pixel by pixel.
#pragma once

#include <bit>

#include "rasterizer/draw/lane_edge.h"

namespace crevice {

// One corner of each triangle, clockwise with the others, from the first pixel centre of its bounds, in 1/256 pixel.
template <class F>
struct TinyCorner {
    Int<F> x, y;
};

// ScreenTriangle::covered of triangles that are `tiny`, of these widths and heights of bounds in pixels. What the corners
// of others hold must not overflow when multiplied.
template <class F>
CREVICE_INLINE Int<F> tiny_coverage(const TinyCorner<F>& a, const TinyCorner<F>& b, const TinyCorner<F>& c,
                                    Int<F> width, Int<F> height, Mask<F> tiny) {
    using I = Int<F>;
    // An edge at the first centre, less its threshold, and how it changes from pixel to pixel.
    struct TinyEdge {
        I here, per_column, per_row;
        CREVICE_INLINE TinyEdge(const TinyCorner<F>& from, const TinyCorner<F>& to)
            : here(from.x * to.y - from.y * to.x),
              per_column((from.y - to.y) * I(kSubpixelSteps)),
              per_row((to.x - from.x) * I(kSubpixelSteps)) {
            const I zero(0);
            const Mask<F> top = (per_column == zero) & (per_row > zero), left = per_column > zero;
            here = here - select(top | left, zero, I(1));
        }
    };
    TinyEdge of_a(b, c), of_b(c, a), of_c(a, b);
    I covered(0);
    for (int y = 0; y < kTinyTriangle_px; ++y) {
        const Mask<F> in_row = tiny & (I(y) < height);
        if (!any(in_row)) break;
        I e0 = of_a.here, e1 = of_b.here, e2 = of_c.here;
        for (int x = 0; x < kTinyTriangle_px; ++x) {
            const Mask<F> in_bounds = in_row & (I(x) < width);
            if (!any(in_bounds)) break;
            const Mask<F> inside = in_bounds & none_negative<F>(e0, e1, e2);
            covered = covered | select(inside, I(1 << (y * kTinyTriangle_px + x)), I(0));
            e0 = e0 + of_a.per_column;
            e1 = e1 + of_b.per_column;
            e2 = e2 + of_c.per_column;
        }
        of_a.here = of_a.here + of_a.per_row;
        of_b.here = of_b.here + of_b.per_row;
        of_c.here = of_c.here + of_c.per_row;
    }
    return covered;
}

// Calls fragment(x, y, z_ndc) for every pixel that a tiny triangle covers.
template <class Fragment>
CREVICE_INLINE void tiny_fragments(const ScreenTriangle& t, const Fragment& fragment) {
    const Edge edge1 = triangle_edge(t, 1), edge2 = triangle_edge(t, 2);
    for (std::uint32_t left = t.covered; left != 0; left &= left - 1) {
        const int pixel = std::countr_zero(left);
        const int x = t.bounds.x0 + pixel % kTinyTriangle_px, y = t.bounds.y0 + pixel / kTinyTriangle_px;
        fragment(x, y,
                 z_ndc_at<float>(t, static_cast<float>(edge1.at(x, y)), static_cast<float>(edge2.at(x, y))));
    }
}

}  // namespace crevice
