// The eye's rays through a group of pixels.
#pragma once

#include "rasterizer/draw/screen_geometry.h"

namespace crevice {

// What the pixels (x, y) ... (x + lanes - 1, y) show at these view depths, view space.
template <class F>
CREVICE_INLINE Vec3<F> p_view_at(const ScreenGeometry& geometry, int x, int y, F view_depth) {
    const F u =
        (F(to_float(lane_index<F>() + Int<F>(x))) + F(0.5f)) / F(static_cast<float>(geometry.size.width));
    const F v = F((static_cast<float>(y) + 0.5f) / static_cast<float>(geometry.size.height));
    return geometry.rays.p_view(u, v, view_depth);
}

// The direction of the eye's ray through the same pixels, view space, with z = 1.
template <class F>
CREVICE_INLINE Vec3<F> view_ray_at(const ScreenGeometry& geometry, int x, int y) {
    if (!geometry.rays.perspective) return {F(0), F(0), F(1)};
    return p_view_at(geometry, x, y, F(1));
}

}  // namespace crevice
