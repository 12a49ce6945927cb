// How much of a texture a pixel covers: from the steps of uv between pixels to mip levels and probes.
// Source: D3D11.3 functional spec 7.18.10, 7.18.11.
#pragma once

#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/textures/sampler.h"

namespace crevice {

template <class F>
struct Vec2 {
    F x, y;
};
template <class F>
CREVICE_INLINE F dot(Vec2<F> a, Vec2<F> b) {
    return a.x * b.x + a.y * b.y;
}

// The squared length of the longer of two steps. The level of what is not a number is 0: see level_of.
template <class F>
CREVICE_INLINE F longest_squared(Vec2<F> a, Vec2<F> b) {
    return max_of(dot(a, a), dot(b, b));
}

// How an anisotropic filter covers a pixel.
template <class F>
struct Footprint {
    Int<F> probes;    // of equal weight
    Vec2<F> axis;     // texels of the full size, from end to end of the row of probes
    F squared_width;  // texels^2 of the full size: a probe's own footprint, which gives its level
};

// A pixel whose neighbours lie `dx` and `dy` texels away is taken for the ellipse that the unit circle
// becomes. Its longer axis is covered by up to `max_probes` probes, each as wide as the shorter axis, but at
// least a texel (nothing finer is there to be seen); where the probes do not suffice they widen. A circle
// needs one.
template <class F>
CREVICE_INLINE Footprint<F> footprint_of(Vec2<F> dx, Vec2<F> dy, int max_probes) {
    const F longest = longest_squared(dx, dy);
    if (max_probes == 1) return {Int<F>(1), {F(0), F(0)}, longest};
    // The ellipse's axes are the eigenvectors of the matrix ((xx, xy), (xy, yy)), their squared lengths its
    // eigenvalues.
    const F xx = dx.x * dx.x + dy.x * dy.x, yy = dx.y * dx.y + dy.y * dy.y, xy = dx.x * dx.y + dy.x * dy.y;
    // Below a texel there is nothing to cover; far beyond any texture the squares overflow.
    const Mask<F> sensible = (xx + yy > F(1)) & (xx + yy < F(1e15f));
    const F difference = F(0.5f) * (xx - yy);
    const F radius = square_root(difference * difference + xy * xy);
    const F longer = square_root(F(0.5f) * (xx + yy) + radius);
    const F shorter = absolute(dx.x * dy.y - dx.y * dy.x) / longer;
    const F ratio =
        select(sensible, min_of(longer / max_of(shorter, F(1)), F(static_cast<float>(max_probes))), F(1));
    constexpr float kSlack = 1 / 64.0f;  // so that rounding does not make two probes of a circle
    const Int<F> probes = Int<F>(1) + floor_to_int(ratio - F(kSlack));
    // Of the two forms of the eigenvector that which does not cancel.
    const Mask<F> wide = difference >= F(0);
    const Vec2<F> direction{select(wide, difference + radius, xy), select(wide, xy, radius - difference)};
    const F squared = dot(direction, direction);
    const Mask<F> several = sensible & (ratio > F(1)) & (probes != Int<F>(1)) & (squared > F(0));
    const F scale = longer / square_root(squared), width = longer / ratio;
    return {select(several, probes, Int<F>(1)),
            {select(several, direction.x * scale, F(0)), select(several, direction.y * scale, F(0))},
            select(several, width * width, longest)};
}

// The mip level, 0 to `last`, whose texels are as wide as a step of this squared length, in texels of the
// full size.
template <class F>
CREVICE_INLINE F level_of(F squared_width, int last) {
    const Mask<F> smaller = squared_width > F(1);
    if (!any(smaller)) return F(0);
    const F level = F(0.5f) * log2_of(select(smaller, min_of(squared_width, F(1e30f)), F(1)));
    return min_of(level, F(static_cast<float>(last)));
}

}  // namespace crevice
