// What kernels in double need beside wide.h: those that make scenes and textures, once.
#pragma once

#include <type_traits>

#include "rasterizer/lanes/wide.h"

namespace crevice {

// The doubles of kernels that are double throughout, kDoubles<F> at a time: four fill AVX2's register, and GCC 12 moves what is
// wider through memory.
template <class F>
using DoubleLanes = std::conditional_t<kLanes<F> == 1, F, Wide<4>>;
template <class F>
using Doubles = Double<DoubleLanes<F>>;
template <class F>
inline constexpr int kDoubles = kLanes<DoubleLanes<F>>;

// max_of and min_of of whole registers, where F says that they are AVX2's. GCC 12 takes wider ones than the machine's apart, and
// does not find the instruction for their halves again.
template <class F>
CREVICE_INLINE Doubles<F> larger(Doubles<F> a, Doubles<F> b) {
    if constexpr (kLanes<F> == 8) {
        return Doubles<F>(a.v > b.v ? a.v : b.v);
    } else {
        return max_of(a, b);
    }
}
template <class F>
CREVICE_INLINE Doubles<F> smaller(Doubles<F> a, Doubles<F> b) {
    if constexpr (kLanes<F> == 8) {
        return Doubles<F>(a.v < b.v ? a.v : b.v);
    } else {
        return min_of(a, b);
    }
}

CREVICE_INLINE WideDouble<4> square_root(WideDouble<4> a) {
    CREVICE_UNROLLED
    for (int i = 0; i < 4; ++i) a.v[i] = __builtin_sqrt(a.v[i]);
    return a;
}

template <class F>
CREVICE_INLINE Doubles<F> load_doubles(const double* at) {
    if constexpr (kDoubles<F> == 1) {
        return *at;
    } else {
        return load<DoubleLanes<F>>(at);
    }
}

}  // namespace crevice
