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
    CREVICE_UNROLLED
    for (int i = 0; i < 4; ++i) {
        a.low[i] = __builtin_sqrt(a.low[i]);
        a.high[i] = __builtin_sqrt(a.high[i]);
    }
    return a;
}

// As many doubles as F has lanes.
template <class F>
CREVICE_INLINE Double<F> load_doubles(const double* at) {
    if constexpr (kLanes<F> == 1) {
        return *at;
    } else if constexpr (kLanes<F> == 8) {
        return of_halves(load<Wide<4>>(at).v, load<Wide<4>>(at + 4).v);
    } else {
        return load<F>(at);
    }
}

}  // namespace crevice
