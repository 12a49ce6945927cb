// How much of the light a surface mirrors.
#pragma once

#include "rasterizer/lanes/vec3.h"

namespace crevice {

// Schlick's approximation: the share of light that is mirrored, from `r0` straight on to 1 at grazing angles.
template <class F>
CREVICE_INLINE Vec3<F> schlick_fresnel(Vec3<F> r0, F cosine) {
    const F one(1), grazing = one - saturate(cosine), grazing2 = grazing * grazing;
    const Vec3<F> ones{one, one, one};
    return r0 + (grazing2 * grazing2 * grazing) * (ones - r0);
}

}  // namespace crevice
