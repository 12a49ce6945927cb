// What kernels in double need beside wide.h: those that make scenes and textures, once.
#pragma once

#include "rasterizer/lanes/wide.h"

namespace crevice {

CREVICE_INLINE WideDouble<4> square_root(WideDouble<4> a) {
    CREVICE_UNROLLED
    for (int i = 0; i < 4; ++i) a.v[i] = __builtin_sqrt(a.v[i]);
    return a;
}
template <int N>
requires(N >= 8) CREVICE_INLINE WideDouble<N> square_root(WideDouble<N> a) {
    CREVICE_UNROLLED
    for (int i = 0; i < N / 2; ++i) {
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
    } else if constexpr (kLanes<F> == 4) {
        return load<F>(at);
    } else {
        Double<F> r;
        std::memcpy(&r.low, at, sizeof r.low);
        std::memcpy(&r.high, at + kLanes<F> / 2, sizeof r.high);
        return r;
    }
}

}  // namespace crevice
