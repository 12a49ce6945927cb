// Read first: the spaces a point walks through, and their conventions. Everything else in the lab refers to
// this page.
//
//   object    as modelled
//   world     left-handed, y up. An OBJ file is right-handed: loading negates z and reverses the winding
//   relative  world axes, origin at the eye
//   view      left-handed: x right, y up, +z the viewing direction. view_depth = z_view, positive in front of
//             the eye
//   clip      homogeneous; visible where w > 0, |x| <= w, |y| <= w, 0 <= z <= w
//   ndc       clip / w: x right, y up, both in [-1,1]; ndc_depth = z in [0,1], near at 0 (reversed z: near at
//             1)
//   screen    pixels, x right, y DOWN, the centre of pixel (i, j) at (i + 0.5, j + 0.5); row 0 of an image is
//             its top row
//   uv        screen / size, in [0,1]^2, (0,0) the top-left corner of the picture
//
// The suffix of a name tells its space (p_view, n_view, p_ndc); a matrix is named target_from_source
// (clip_from_view), so that equal names touch in a product. Vectors are columns. A variable never changes its
// space. Front faces are clockwise on the screen. A pixel is covered when its centre is inside the triangle,
// or on a top edge or a left edge. Lengths are scene units, angles radians, times ms. AO images hold
// accessibility: 1 open, 0 closed.
#pragma once

#include <glm/vec2.hpp>

#include "rasterizer/base/image.h"
#include "rasterizer/lanes/vec3.h"

namespace crevice {

// Screen position of an ndc position (D3D11.3 functional spec 15.6 without offset).
template <class F>
CREVICE_INLINE F screen_x_from_ndc(F x_ndc, F width_px) {
    return (x_ndc + F(1)) * (width_px * F(0.5f));
}
template <class F>
CREVICE_INLINE F screen_y_from_ndc(F y_ndc, F height_px) {
    return (F(1) - y_ndc) * (height_px * F(0.5f));
}

template <class F>
struct Screen2 {
    F x, y;  // pixels
};

// How many sub-pixel steps a pixel has: screen positions are snapped to 16.8 fixed point.
inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixelSteps = 1 << kSubpixelBits;

// The way from a picture position to a view-space position and back, for either projection.
struct ViewRays {
    glm::vec2 ray_scale;  // CameraMatrices::ray_scale
    Size size;            // of the picture
    bool perspective;

    // p_view at uv with view depth z.
    template <class F>
    CREVICE_INLINE Vec3<F> p_view(F u, F v, F z) const {
        const F x = (F(2) * u - F(1)) * F(ray_scale.x);
        const F y = (F(1) - F(2) * v) * F(ray_scale.y);
        return perspective ? Vec3<F>{x * z, y * z, z} : Vec3<F>{x, y, z};
    }

    // Screen position of a view-space position; `inverse_z` is 1 / p_view.z.
    template <class F>
    CREVICE_INLINE Screen2<F> p_screen(Vec3<F> p_view, F inverse_z) const {
        const F scale = perspective ? inverse_z : F(1);
        const float half_width = 0.5f * static_cast<float>(size.width);
        const float half_height = 0.5f * static_cast<float>(size.height);
        return {F(half_width) + p_view.x * scale * F(half_width / ray_scale.x),
                F(half_height) - p_view.y * scale * F(half_height / ray_scale.y)};
    }

    // The point with view depth z on the eye's ray through p_view.
    template <class F>
    CREVICE_INLINE Vec3<F> at_depth(Vec3<F> p_view, F inverse_z, F z) const {
        return perspective ? (z * inverse_z) * p_view : Vec3<F>{p_view.x, p_view.y, z};
    }
};

}  // namespace crevice
