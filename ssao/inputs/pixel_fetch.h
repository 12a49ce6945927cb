// What the picture's pixels show, by the nearest pixel: the fetch of the methods that step across the screen.
#pragma once

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// The pixel that holds a screen position, and the surface there. Beyond the picture it is what AoFetch::border says,
// and the background lies far away (kBackgroundOverFar). `inputs` must be fetched as DepthSource::view_depth.
template <class F>
struct FetchedPixel {
    Screen2<F> at;  // its centre, pixels of the picture
    Vec3<F> r;      // view space
};

template <class F>
CREVICE_INLINE FetchedPixel<F> fetch_pixel(const AoInputs& inputs, Screen2<F> position) {
    const F width = F(static_cast<float>(inputs.picture.width)),
            height = F(static_cast<float>(inputs.picture.height));
    // One column and row beyond the picture stand for all that is there. NaN becomes the first of them.
    const Int<F> column = floor_to_int(min_of(max_of(position.x, F(-1)), width)),
                 row = floor_to_int(min_of(max_of(position.y, F(-1)), height));
    const Image<float>& map = inputs.depth_map;
    const Int<F> index = row * Int<F>(map.stride) + column + Int<F>(map.stride + 1);
    const Screen2<F> at = {F(to_float(column)) + F(0.5f), F(to_float(row)) + F(0.5f)};
    return {at, inputs.rays.p_view(at.x / width, at.y / height, inputs.mapped_depth<F>(index))};
}

// How the methods that step across the screen read the G-buffer: each texel its own pixel's normal, depths in scene units.
// `settings` have a member ao_scale.
template <class S>
AoFetch pixel_fetch(const S& settings) {
    return {.depth = DepthSource::view_depth, .point_normals = true, .scale = settings.ao_scale};
}

// How many pixels of the picture a length of one scene unit across the view takes at view depth 1 (orthographic: at any
// depth), down the picture; across it the same, for square pixels.
inline float pixels_per_unit(const AoInputs& inputs) {
    return 0.5f * static_cast<float>(inputs.picture.height) / inputs.rays.ray_scale.y;
}

// A length in scene units at view depth z, as pixels of the picture.
template <class F>
CREVICE_INLINE F length_px(const AoInputs& inputs, float length, F z) {
    const F at_depth_1 = F(length * pixels_per_unit(inputs));
    return inputs.rays.perspective ? at_depth_1 / z : at_depth_1;
}

// How far from a texel's centre, pixels of the picture, a method reads that looks so far around a point at this view depth.
// The two pixels more: the texel's own lies beside its centre, and what is fetched beside its place.
inline constexpr double kBesides_px = 2;
inline double reach_of_length_px(const AoInputs& inputs, double length, double view_depth) {
    return length_px(inputs, 1.0f, view_depth) * length + kBesides_px;
}

}  // namespace crevice
