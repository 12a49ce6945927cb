// What kernels in double need beside wide.h: those that make scenes and textures, once.
#pragma once

#include "rasterizer/lanes/wide.h"

namespace crevice {

CREVICE_INLINE WideDouble<4> square_root(WideDouble<4> a) {
    CREVICE_UNROLLED
    for (int i = 0; i < 4; ++i) a.v[i] = __builtin_sqrt(a.v[i]);
    return a;
}
CREVICE_INLINE WideDouble<8> square_root(WideDouble<8> a) {
    return WideDouble<8>(
        joined(square_root(WideDouble<4>(low_half(a.v))).v, square_root(WideDouble<4>(high_half(a.v))).v));
}

// As many doubles as F has lanes.
template <class F>
CREVICE_INLINE Double<F> load_doubles(const double* at) {
    if constexpr (kLanes<F> == 1) {
        return *at;
    } else {
        return load<F>(at);
    }
}

}  // namespace crevice
