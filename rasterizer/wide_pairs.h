// Neighbouring texels, two at a time: what linear filters read. Half the loads of gathering each alone.
#pragma once

#include "rasterizer/wide.h"

namespace crevice {

template <class F>
struct Pair {
    F first, second;
};

// base[index] and base[index + 1], and the same two of the next row. index >= 0.
template <class F>
struct Square {
    F upper_left, upper_right, lower_left, lower_right;
};
CREVICE_INLINE Square<float> gather_square(const float* base, int stride, std::int32_t index) {
    const float *upper = base + index, *lower = upper + stride;
    return {upper[0], upper[1], lower[0], lower[1]};
}
// The even and the odd ones of as many pairs as there are lanes.
template <class F>
    requires(kLanes<F> == 1)
CREVICE_INLINE Pair<float> load_pairs(const float* at) {
    return {at[0], at[1]};
}

// ---- eight lanes

// The first and the second ones of eight pairs, given as those of lanes 0 1 4 5 and 2 3 6 7: then one shuffle
// inside each 128-bit half parts them.
CREVICE_INLINE Pair<Wide<8>> part_pairs(Wide<8> lanes_0145, Wide<8> lanes_2367) {
    return {Wide<8>(__builtin_shufflevector(lanes_0145.v, lanes_2367.v, 0, 2, 8, 10, 4, 6, 12, 14)),
            Wide<8>(__builtin_shufflevector(lanes_0145.v, lanes_2367.v, 1, 3, 9, 11, 5, 7, 13, 15))};
}
// One 64-bit load a lane and row instead of two. Unsigned, because that needs no sign extension.
CREVICE_INLINE Square<Wide<8>> gather_square(const float* base, int stride, WideInt<8> index) {
    typedef std::int64_t FourPairs __attribute__((vector_size(32)));
    const auto pairs = [&](const float* row, int a, int b, int c, int d) __attribute__((always_inline)) {
        const auto pair = [&](int lane) __attribute__((always_inline)) {
            std::int64_t bits;
            std::memcpy(&bits, row + static_cast<std::uint32_t>(index.v[lane]), sizeof bits);
            return bits;
        };
        const FourPairs four = {pair(a), pair(b), pair(c), pair(d)};
        return Wide<8>(__builtin_bit_cast(Wide<8>::V, four));
    };
    const float* next = base + stride;
    const Pair<Wide<8>> upper = part_pairs(pairs(base, 0, 1, 4, 5), pairs(base, 2, 3, 6, 7));
    const Pair<Wide<8>> lower = part_pairs(pairs(next, 0, 1, 4, 5), pairs(next, 2, 3, 6, 7));
    return {upper.first, upper.second, lower.first, lower.second};
}
template <class F>
    requires(kLanes<F> == 8)
CREVICE_INLINE Pair<F> load_pairs(const float* at) {
    const F low = load<F>(at), high = load<F>(at + 8);
    return {F(__builtin_shufflevector(low.v, high.v, 0, 2, 4, 6, 8, 10, 12, 14)),
            F(__builtin_shufflevector(low.v, high.v, 1, 3, 5, 7, 9, 11, 13, 15))};
}

}  // namespace crevice
