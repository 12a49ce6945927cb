// Four numbers of each lane that lie side by side in memory: the channels of a texel, a row of texels. They are loaded
// together and computed with as they lie, when all four take the same arithmetic; sorted they are once, at the end.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "rasterizer/lanes/wide.h"

namespace crevice {

// The four of one lane (F = float or Wide<4>), of two (Wide<8>: lane i in the lower half and lane i + 4 in the upper one), or
// of four (Wide<16>: lanes i, i + 4, i + 8 and i + 12). So several lanes are four of these, and one lane is one.
template <class F, class T = float>
struct Fours {
    using V = typename VectorOf<T, kLanes<F> == 1 ? 4 : kLanes<F>>::type;
    V v;
};
template <class F>
inline constexpr int kFours = kLanes<F> == 1 ? 1 : 4;

// As mix of wide.h, number by number.
template <class F>
CREVICE_INLINE Fours<F> mix(Fours<F> a, Fours<F> b, Fours<F> t) {
    return {a.v + t.v * (b.v - a.v)};
}

// One four in the place of each.
template <class F, class V4>
CREVICE_INLINE auto joined_fours(const V4& of_lane) {
    if constexpr (kLanes<F> == 16) {
        return joined(joined(of_lane(0), of_lane(4)), joined(of_lane(8), of_lane(12)));
    } else if constexpr (kLanes<F> == 8) {
        return joined(of_lane(0), of_lane(4));
    } else {
        return of_lane(0);
    }
}

// The fours that begin at base[index[0]] and, of more than four lanes, base[index[4]] and so on. No index is below 0.
template <class F, class T>
CREVICE_INLINE Fours<F, T> gather_fours(const T* base, const std::int32_t* index) {
    return {joined_fours<F>([&](int lane) __attribute__((always_inline)) {
        typename VectorOf<T, 4>::type v;
        // Unsigned, because that needs no sign extension.
        std::memcpy(&v, base + static_cast<std::uint32_t>(index[lane]), sizeof v);
        return v;
    })};
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
template <class T>
CREVICE_INLINE void spread_to_fours(WideOf<T, 16> value, Fours<Wide<16>, T> (&spread)[4]) {
    spread[0].v =
        __builtin_shufflevector(value.v, value.v, 0, 0, 0, 0, 4, 4, 4, 4, 8, 8, 8, 8, 12, 12, 12, 12);
    spread[1].v =
        __builtin_shufflevector(value.v, value.v, 1, 1, 1, 1, 5, 5, 5, 5, 9, 9, 9, 9, 13, 13, 13, 13);
    spread[2].v =
        __builtin_shufflevector(value.v, value.v, 2, 2, 2, 2, 6, 6, 6, 6, 10, 10, 10, 10, 14, 14, 14, 14);
    spread[3].v =
        __builtin_shufflevector(value.v, value.v, 3, 3, 3, 3, 7, 7, 7, 7, 11, 11, 11, 11, 15, 15, 15, 15);
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

// Four of them.
CREVICE_INLINE std::array<Wide<16>, 4> sorted(const Fours<Wide<16>> (&fours)[4]) {
    using V = Wide<16>::V;
    const auto lower = [](V a, V b) __attribute__((always_inline)) {
        return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
    };
    const auto upper = [](V a, V b) __attribute__((always_inline)) {
        return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
    };
    const auto lower_pairs = [](V a, V b) __attribute__((always_inline)) {
        return Wide<16>(
            __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29));
    };
    const auto upper_pairs = [](V a, V b) __attribute__((always_inline)) {
        return Wide<16>(
            __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31));
    };
    const V low01 = lower(fours[0].v, fours[1].v), low23 = lower(fours[2].v, fours[3].v),
            high01 = upper(fours[0].v, fours[1].v), high23 = upper(fours[2].v, fours[3].v);
    return {lower_pairs(low01, low23), upper_pairs(low01, low23), lower_pairs(high01, high23),
            upper_pairs(high01, high23)};
}

}  // namespace crevice
