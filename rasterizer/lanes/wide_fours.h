// Four numbers of each lane that lie side by side in memory: the channels of a texel, a row of texels. They are loaded
// together and computed with as they lie, when all four take the same arithmetic; sorted they are once, at the end.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "rasterizer/lanes/wide.h"

namespace crevice {

// The four of one lane (F = float or Wide<4>), or of two (Wide<8>): of lane i in the lower half and of lane i + 4 in the
// upper one. So four lanes and eight are four of these, and one lane is one.
template <class F, class T = float>
struct Fours {
    using V = typename VectorOf<T, kLanes<F> == 8 ? 8 : 4>::type;
    V v;
};
template <class F>
inline constexpr int kFours = kLanes<F> == 1 ? 1 : 4;

// As mix of wide.h, number by number.
template <class F>
CREVICE_INLINE Fours<F> mix(Fours<F> a, Fours<F> b, Fours<F> t) {
    return {a.v + t.v * (b.v - a.v)};
}

// The fours that begin at base[index[0]] and, of eight lanes, base[index[4]]. No index is below 0.
template <class F, class T>
CREVICE_INLINE Fours<F, T> gather_fours(const T* base, const std::int32_t* index) {
    const auto four = [&](std::int32_t i) __attribute__((always_inline)) {
        typename VectorOf<T, 4>::type v;
        // Unsigned, because that needs no sign extension.
        std::memcpy(&v, base + static_cast<std::uint32_t>(i), sizeof v);
        return v;
    };
    if constexpr (kLanes<F> == 8) {
        return {joined(four(index[0]), four(index[4]))};
    } else {
        return {four(index[0])};
    }
}

// A value of each lane, four times.
template <class T>
CREVICE_INLINE void spread_to_fours(T value, Fours<float, T> (&spread)[1]) {
    spread[0].v = typename Fours<float, T>::V{value, value, value, value};
}
template <class T>
CREVICE_INLINE void spread_to_fours(WideOf<T, 4> value, Fours<Wide<4>, T> (&spread)[4]) {
    spread[0].v = __builtin_shufflevector(value.v, value.v, 0, 0, 0, 0);
    spread[1].v = __builtin_shufflevector(value.v, value.v, 1, 1, 1, 1);
    spread[2].v = __builtin_shufflevector(value.v, value.v, 2, 2, 2, 2);
    spread[3].v = __builtin_shufflevector(value.v, value.v, 3, 3, 3, 3);
}
template <class T>
CREVICE_INLINE void spread_to_fours(WideOf<T, 8> value, Fours<Wide<8>, T> (&spread)[4]) {
    spread[0].v = __builtin_shufflevector(value.v, value.v, 0, 0, 0, 0, 4, 4, 4, 4);
    spread[1].v = __builtin_shufflevector(value.v, value.v, 1, 1, 1, 1, 5, 5, 5, 5);
    spread[2].v = __builtin_shufflevector(value.v, value.v, 2, 2, 2, 2, 6, 6, 6, 6);
    spread[3].v = __builtin_shufflevector(value.v, value.v, 3, 3, 3, 3, 7, 7, 7, 7);
}

// The first, second, third and fourth numbers of all lanes.
CREVICE_INLINE std::array<float, 4> sorted(const Fours<float> (&fours)[1]) {
    return {fours[0].v[0], fours[0].v[1], fours[0].v[2], fours[0].v[3]};
}
// A transposition of 4 x 4.
CREVICE_INLINE std::array<Wide<4>, 4> sorted(const Fours<Wide<4>> (&fours)[4]) {
    using V = Wide<4>::V;
    const V low01 = __builtin_shufflevector(fours[0].v, fours[1].v, 0, 4, 1, 5),
            low23 = __builtin_shufflevector(fours[2].v, fours[3].v, 0, 4, 1, 5),
            high01 = __builtin_shufflevector(fours[0].v, fours[1].v, 2, 6, 3, 7),
            high23 = __builtin_shufflevector(fours[2].v, fours[3].v, 2, 6, 3, 7);
    return {Wide<4>(__builtin_shufflevector(low01, low23, 0, 1, 4, 5)),
            Wide<4>(__builtin_shufflevector(low01, low23, 2, 3, 6, 7)),
            Wide<4>(__builtin_shufflevector(high01, high23, 0, 1, 4, 5)),
            Wide<4>(__builtin_shufflevector(high01, high23, 2, 3, 6, 7))};
}
// Two of them, side by side.
CREVICE_INLINE std::array<Wide<8>, 4> sorted(const Fours<Wide<8>> (&fours)[4]) {
    using V = Wide<8>::V;
    const V low01 = __builtin_shufflevector(fours[0].v, fours[1].v, 0, 8, 1, 9, 4, 12, 5, 13),
            low23 = __builtin_shufflevector(fours[2].v, fours[3].v, 0, 8, 1, 9, 4, 12, 5, 13),
            high01 = __builtin_shufflevector(fours[0].v, fours[1].v, 2, 10, 3, 11, 6, 14, 7, 15),
            high23 = __builtin_shufflevector(fours[2].v, fours[3].v, 2, 10, 3, 11, 6, 14, 7, 15);
    return {Wide<8>(__builtin_shufflevector(low01, low23, 0, 1, 8, 9, 4, 5, 12, 13)),
            Wide<8>(__builtin_shufflevector(low01, low23, 2, 3, 10, 11, 6, 7, 14, 15)),
            Wide<8>(__builtin_shufflevector(high01, high23, 0, 1, 8, 9, 4, 5, 12, 13)),
            Wide<8>(__builtin_shufflevector(high01, high23, 2, 3, 10, 11, 6, 7, 14, 15))};
}

}  // namespace crevice
