// What kernels in double need beside wide.h: those that make scenes and textures, once.
#pragma once

#include <type_traits>

#include "rasterizer/lanes/wide.h"

namespace crevice {

// The lanes of kernels that are double throughout: four fill AVX2's register, and GCC 12 moves what is wider through memory.
template <class F>
using DoubleLanes = std::conditional_t<kLanes<F> == 1, F, Wide<4>>;

// Without the way through a 32-bit mask.
template <int N>
CREVICE_INLINE WideDouble<N> absolute(WideDouble<N> a) {
    return max_of(a, WideDouble<N>(0) - a);
}

CREVICE_INLINE WideDouble<4> square_root(WideDouble<4> a) {
    CREVICE_UNROLLED
    for (int i = 0; i < 4; ++i) a.v[i] = __builtin_sqrt(a.v[i]);
    return a;
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
