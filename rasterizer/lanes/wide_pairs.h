// Neighbouring texels, two at a time: what linear filters read. Half the loads of gathering each alone.
#pragma once

#include "rasterizer/lanes/wide.h"

namespace crevice {

template <class F>
struct Pair {
    F first, second;
};

// base[index] and base[index + 1] as they lie in memory: one 64-bit load instead of two. Unsigned, because that
// needs no sign extension.
CREVICE_INLINE std::int64_t pair_bits(const float* base, std::int32_t index) {
    std::int64_t bits;
    std::memcpy(&bits, base + static_cast<std::uint32_t>(index), sizeof bits);
    return bits;
}

// base[index] and base[index + 1], and the same two of the next row. index >= 0.
template <class F>
struct Square {
    F upper_left, upper_right, lower_left, lower_right;
};
CREVICE_INLINE Square<float> gather_square(const float* base, int stride, std::int32_t index) {
    const float *upper = base + index, *lower = upper + stride;
    return {upper[0], upper[1], lower[0], lower[1]};
}
// at[0], at[2], at[4] ... and at[1], at[3], at[5] ...: as many of each as there are lanes.
template <class F>
requires(kLanes<F> == 1) CREVICE_INLINE Pair<float> load_pairs(const float* at) { return {at[0], at[1]}; }

// ---- four lanes

CREVICE_INLINE Pair<Wide<4>> part_pairs(Wide<4> lanes_01, Wide<4> lanes_23) {
    return {Wide<4>(__builtin_shufflevector(lanes_01.v, lanes_23.v, 0, 2, 4, 6)),
            Wide<4>(__builtin_shufflevector(lanes_01.v, lanes_23.v, 1, 3, 5, 7))};
}
CREVICE_INLINE Pair<Wide<4>> gather_pairs(const float* base, WideInt<4> index) {
    const auto pairs = [&](int a, int b) __attribute__((always_inline)) {
        const VectorOf<std::int64_t, 2>::type two = {pair_bits(base, index.v[a]),
                                                     pair_bits(base, index.v[b])};
        return Wide<4>(__builtin_bit_cast(Wide<4>::V, two));
    };
    return part_pairs(pairs(0, 1), pairs(2, 3));
}
CREVICE_INLINE Pair<Wide<4>> load_four_pairs(const float* at) {
    return part_pairs(load<Wide<4>>(at), load<Wide<4>>(at + 4));
}

// ---- eight lanes

// The first and the second ones of eight pairs, given as those of lanes 0 1 4 5 and 2 3 6 7: then one shuffle
// inside each 128-bit half parts them.
CREVICE_INLINE Pair<Wide<8>> part_pairs(Wide<8> lanes_0145, Wide<8> lanes_2367) {
    return {Wide<8>(__builtin_shufflevector(lanes_0145.v, lanes_2367.v, 0, 2, 8, 10, 4, 6, 12, 14)),
            Wide<8>(__builtin_shufflevector(lanes_0145.v, lanes_2367.v, 1, 3, 9, 11, 5, 7, 13, 15))};
}
CREVICE_INLINE Pair<Wide<8>> gather_pairs(const float* base, WideInt<8> index) {
    const auto pairs = [&](int a, int b, int c, int d) __attribute__((always_inline)) {
        const VectorOf<std::int64_t, 4>::type four = {
            pair_bits(base, index.v[a]), pair_bits(base, index.v[b]), pair_bits(base, index.v[c]),
            pair_bits(base, index.v[d])};
        return Wide<8>(__builtin_bit_cast(Wide<8>::V, four));
    };
    return part_pairs(pairs(0, 1, 4, 5), pairs(2, 3, 6, 7));
}
CREVICE_INLINE Pair<Wide<8>> load_eight_pairs(const float* at) {
    const Wide<8> low = load<Wide<8>>(at), high = load<Wide<8>>(at + 8);
    return {Wide<8>(__builtin_shufflevector(low.v, high.v, 0, 2, 4, 6, 8, 10, 12, 14)),
            Wide<8>(__builtin_shufflevector(low.v, high.v, 1, 3, 5, 7, 9, 11, 13, 15))};
}

// ---- sixteen lanes

// As eight, twice: given as the pairs of lanes 0 1 4 5 8 9 12 13 and those between.
CREVICE_INLINE Pair<Wide<16>> gather_pairs(const float* base, WideInt<16> index) {
    const auto pairs = [&](int a, int b, int c, int d) __attribute__((always_inline)) {
        const VectorOf<std::int64_t, 4>::type four = {
            pair_bits(base, index.v[a]), pair_bits(base, index.v[b]), pair_bits(base, index.v[c]),
            pair_bits(base, index.v[d])};
        return __builtin_bit_cast(Wide<8>::V, four);
    };
    const Wide<16>::V a = joined(pairs(0, 1, 4, 5), pairs(8, 9, 12, 13)),
                      b = joined(pairs(2, 3, 6, 7), pairs(10, 11, 14, 15));
    return {Wide<16>(__builtin_shufflevector(a, b, 0, 2, 16, 18, 4, 6, 20, 22, 8, 10, 24, 26, 12, 14, 28, 30)),
            Wide<16>(__builtin_shufflevector(a, b, 1, 3, 17, 19, 5, 7, 21, 23, 9, 11, 25, 27, 13, 15, 29, 31))};
}
CREVICE_INLINE Pair<Wide<16>> load_sixteen_pairs(const float* at) {
    const Wide<16>::V low = load<Wide<16>>(at).v, high = load<Wide<16>>(at + 16).v;
    return {Wide<16>(__builtin_shufflevector(low, high, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30)),
            Wide<16>(__builtin_shufflevector(low, high, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31))};
}

// ---- several lanes

template <int N>
CREVICE_INLINE Square<Wide<N>> gather_square(const float* base, int stride, WideInt<N> index) {
    const Pair<Wide<N>> upper = gather_pairs(base, index), lower = gather_pairs(base + stride, index);
    return {upper.first, upper.second, lower.first, lower.second};
}
template <class F>
requires(kLanes<F> > 1) CREVICE_INLINE Pair<F> load_pairs(const float* at) {
    if constexpr (kLanes<F> == 4) {
        return load_four_pairs(at);
    } else if constexpr (kLanes<F> == 8) {
        return load_eight_pairs(at);
    } else {
        return load_sixteen_pairs(at);
    }
}

}  // namespace crevice
