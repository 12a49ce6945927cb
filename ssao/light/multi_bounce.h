// Ambient occlusion with the light that occluders themselves reflect: brighter, the more so the brighter they are.
// Source: Jimenez et al. 2016, "Practical real-time strategies for accurate indirect occlusion": a cubic fit
//         to path-traced scenes of one albedo
#pragma once

#include "rasterizer/lanes/vec3.h"
#include "ssao/light/ambient_use.h"

namespace crevice {

// ((a A + b) A + c) A, where a, b, c are these slopes times the albedo and these offsets.
struct MultiBounceFit {
    float a_slope, a_offset, b_slope, b_offset, c_slope, c_offset;
};
inline constexpr MultiBounceFit kPaperFit = {2.0404f, -0.3324f, -4.7951f, 0.6417f, 2.7552f, 0.6903f};
// The Unity notes': up to .043 darker, where nearly all is open.
inline constexpr MultiBounceFit kRoundedFit = {2, -0.33f, -4.8f, 0.64f, 2.75f, 0.69f};

// In [accessibility, 1]. Accessibility in [0, 1]; the albedo of a colour channel is brought into that. At 1 it is exactly
// 1, with either fit: less than the accessibility it never becomes.
template <class F>
CREVICE_INLINE F multi_bounce(F accessibility, F albedo, const MultiBounceFit& fit) {
    const F colour = saturate(albedo);
    const F a = F(fit.a_slope) * colour + F(fit.a_offset), b = F(fit.b_slope) * colour + F(fit.b_offset),
            c = F(fit.c_slope) * colour + F(fit.c_offset);
    const F bounced = ((a * accessibility + b) * accessibility + c) * accessibility;
    return min_of(max_of(bounced, accessibility), F(1));
}

// What each colour channel of ambient light is multiplied by.
template <class F>
CREVICE_INLINE Vec3<F> ambient_access(MultiBounce bounces, F accessibility, Vec3<F> albedo) {
    if (bounces == MultiBounce::none) return {accessibility, accessibility, accessibility};
    const MultiBounceFit& fit = bounces == MultiBounce::paper ? kPaperFit : kRoundedFit;
    return {multi_bounce(accessibility, albedo.x, fit), multi_bounce(accessibility, albedo.y, fit),
            multi_bounce(accessibility, albedo.z, fit)};
}

}  // namespace crevice
