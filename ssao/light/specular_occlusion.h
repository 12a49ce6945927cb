// How much of what a surface mirrors of its surroundings is not hidden.
// Source: Jimenez et al. 2016, "Practical real-time strategies for accurate indirect occlusion" (GTSO): the
//         cone of open directions meets that of mirrored ones; their intersection as in Oat and Sander 2007, "Ambient
//         aperture lighting". Lagarde and de Rousiers 2014, "Moving Frostbite to physically based rendering"
// In:     unit vectors of one space; accessibility in [0, 1], cosine-weighted; roughness in [0, 1]
// Out:    [0, 1]; exactly 1 where accessibility is 1 and the open directions lie about the normal
// Error:  against the integral over the mirrored cone, over roughnesses, accessibilities and angles of all kinds, RMSE
//         .033 by cones; .29 by Lagarde's, which knows neither the cone nor where the open directions lie
// Differs from the source: the cone of mirrored directions counts above the surface alone, for below it nothing is
//         mirrored whatever occludes.
#pragma once

#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/lanes/arc_cosine.h"
#include "rasterizer/lanes/vec3.h"

namespace crevice {

// The solid angle that two cones have in common, over 2 pi. Cosines of their half angles and of the angle between their
// axes; a smooth step between all of the smaller one and nothing, at most .11 of the smaller one wrong.
template <class F>
CREVICE_INLINE F cones_in_common(F first, F second, F between) {
    const F r1 = arc_cosine(first), r2 = arc_cosine(second), apart = arc_cosine(between);
    const F smaller = F(1) - max_of(first, second);  // the whole of it
    const F nearest = absolute(r1 - r2);             // up to here one lies in the other
    const F range = r1 + r2 - nearest;
    const F outside = saturate((apart - nearest) / select(range > F(0), range, F(1)));
    const F inside = F(1) - select(range > F(0), outside, select(apart > nearest, F(1), F(0)));
    return inside * inside * (F(3) - F(2) * inside) * smaller;
}

// The half angle of a cone of mirrored directions, as its cosine: one tenth to the power of the squared roughness. A
// mirror keeps a cone that is not empty.
template <class F>
CREVICE_INLINE F mirrored_cone(F roughness) {
    constexpr float kLog2OfTen = 3.3219281f, kNarrowest = 0.9998f;
    return min_of(exp2_of(F(-kLog2OfTen) * roughness * roughness), F(kNarrowest));
}

// `open` is the axis of the open directions, the bent normal, and `mirrored` the direction in which the eye's ray leaves.
template <class F>
CREVICE_INLINE F specular_occlusion_by_cones(F accessibility, Vec3<F> open, Vec3<F> n, Vec3<F> mirrored,
                                             F roughness) {
    const F open_cone = square_root(F(1) - accessibility), cone = mirrored_cone(roughness);
    const F visible = cones_in_common(open_cone, cone, dot(open, mirrored));
    // An interpolated normal may point away from the eye; then nothing is mirrored above the surface.
    const F above = dot(n, mirrored);
    const auto mirrors = above > F(0);
    const F above_surface = cones_in_common(F(0), cone, max_of(above, F(0)));
    return select(mirrors, min_of(visible / above_surface, F(1)), accessibility);
}

// From the cosine between normal and eye alone: the rougher, the nearer to accessibility itself.
template <class F>
CREVICE_INLINE F specular_occlusion_by_lagarde(F accessibility, F n_dot_eye, F roughness) {
    const F power_of = exp2_of(F(-16) * roughness - F(1));
    return saturate(power(max_of(n_dot_eye, F(0)) + accessibility, power_of) - F(1) + accessibility);
}

}  // namespace crevice
