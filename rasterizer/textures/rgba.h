// Texels as they lie in memory, the four channels side by side: a filter mixes them without sorting them by
// channel first, since all four take the same arithmetic.
#pragma once

#include <array>
#include <cstring>

#include "rasterizer/lanes/vec3.h"

namespace crevice {

// RGBA as whole numbers from 0 to kTexelOne, which stands for 1. This one because every code of 8 bits and every
// 256th is a whole number of it: level normals, opaque alpha and data of 8 bits are stored exactly.
using Rgba16 = std::array<std::uint16_t, 4>;
inline constexpr float kTexelOne = 255 * 256;

// RGBA of one pixel (F = float or Wide<4>), or of two pixels (Wide<8>): of lane i in the lower half and of lane
// i + 4 in the upper one. So four lanes and eight are four of these, and one lane is one.
template <class F>
struct Rgba {
    using V = Wide<4>::V;
    V v;
};
template <>
struct Rgba<Wide<8>> {
    using V = Wide<8>::V;
    V v;
};
template <class F>
inline constexpr int kRgbas = kLanes<F> == 1 ? 1 : 4;

// As mix of wide.h, channel by channel.
template <class F>
CREVICE_INLINE Rgba<F> mix(Rgba<F> a, Rgba<F> b, Rgba<F> t) {
    return {a.v + t.v * (b.v - a.v)};
}
// a where `where` is above 0, else b.
template <class F>
CREVICE_INLINE Rgba<F> chosen(Rgba<F> where, Rgba<F> a, Rgba<F> b) {
    return {where.v > typename Rgba<F>::V{} ? a.v : b.v};
}
template <class F>
CREVICE_INLINE Rgba<F> over_all_pixels(const float* rgba) {
    Wide<4>::V v;
    std::memcpy(&v, rgba, sizeof v);
    if constexpr (kLanes<F> == 8) {
        return {joined(v, v)};
    } else {
        return {v};
    }
}

// Two texels that lie side by side, in units of 1 / kTexelOne.
template <class F>
struct TexelPair {
    Rgba<F> left, right;
};

typedef std::uint16_t TwoTexels __attribute__((vector_size(16)));
typedef std::uint16_t FourTexels __attribute__((vector_size(32)));

// Each 16-bit number between a zero and the next: as many 32-bit numbers. An interleaving takes every second half
// of a register apart.
CREVICE_INLINE TexelPair<float> unpacked(TwoTexels codes) {
    using Words = WideInt<4>::V;
    const TwoTexels zero = {};
    const auto left = __builtin_shufflevector(codes, zero, 0, 8, 1, 9, 2, 10, 3, 11),
               right = __builtin_shufflevector(codes, zero, 4, 12, 5, 13, 6, 14, 7, 15);
    return {{to_float(WideInt<4>(__builtin_bit_cast(Words, left))).v},
            {to_float(WideInt<4>(__builtin_bit_cast(Words, right))).v}};
}
CREVICE_INLINE TexelPair<Wide<8>> unpacked(FourTexels codes) {
    using Words = WideInt<8>::V;
    const FourTexels zero = {};
    const auto left = __builtin_shufflevector(codes, zero, 0, 16, 1, 17, 2, 18, 3, 19, 8, 24, 9, 25, 10, 26,
                                              11, 27),
               right = __builtin_shufflevector(codes, zero, 4, 20, 5, 21, 6, 22, 7, 23, 12, 28, 13, 29, 14,
                                               30, 15, 31);
    return {{to_float(WideInt<8>(__builtin_bit_cast(Words, left))).v},
            {to_float(WideInt<8>(__builtin_bit_cast(Words, right))).v}};
}

// The pairs that begin at base[index[0]] and, of eight lanes, base[index[4]]. No index is below 0.
template <class F>
CREVICE_INLINE TexelPair<F> gather_pair(const Rgba16* base, const std::int32_t* index) {
    using Bits = VectorOf<std::int64_t, 2>::type;
    const auto pair = [&](std::int32_t i) __attribute__((always_inline)) {
        Bits bits;
        // Unsigned, because that needs no sign extension.
        std::memcpy(&bits, base + static_cast<std::uint32_t>(i), sizeof bits);
        return bits;
    };
    if constexpr (kLanes<F> == 8) {
        return unpacked(__builtin_bit_cast(FourTexels, joined(pair(index[0]), pair(index[4]))));
    } else {
        const TexelPair<float> two = unpacked(__builtin_bit_cast(TwoTexels, pair(index[0])));
        return {{two.left.v}, {two.right.v}};
    }
}

// A value of each lane, on all four of its channels.
CREVICE_INLINE void spread_to_channels(float value, Rgba<float> (&spread)[1]) {
    spread[0].v = Rgba<float>::V{value, value, value, value};
}
CREVICE_INLINE void spread_to_channels(Wide<4> value, Rgba<Wide<4>> (&spread)[4]) {
    spread[0].v = __builtin_shufflevector(value.v, value.v, 0, 0, 0, 0);
    spread[1].v = __builtin_shufflevector(value.v, value.v, 1, 1, 1, 1);
    spread[2].v = __builtin_shufflevector(value.v, value.v, 2, 2, 2, 2);
    spread[3].v = __builtin_shufflevector(value.v, value.v, 3, 3, 3, 3);
}
CREVICE_INLINE void spread_to_channels(Wide<8> value, Rgba<Wide<8>> (&spread)[4]) {
    spread[0].v = __builtin_shufflevector(value.v, value.v, 0, 0, 0, 0, 4, 4, 4, 4);
    spread[1].v = __builtin_shufflevector(value.v, value.v, 1, 1, 1, 1, 5, 5, 5, 5);
    spread[2].v = __builtin_shufflevector(value.v, value.v, 2, 2, 2, 2, 6, 6, 6, 6);
    spread[3].v = __builtin_shufflevector(value.v, value.v, 3, 3, 3, 3, 7, 7, 7, 7);
}

// Sorted by channel.
template <class F>
struct TextureColour {
    Vec3<F> colour;  // linear light, [0,1]
    F alpha;         // [0,1]; 1 where the texture has none
};
CREVICE_INLINE TextureColour<float> channels_of(const Rgba<float> (&rgba)[1]) {
    return {{rgba[0].v[0], rgba[0].v[1], rgba[0].v[2]}, rgba[0].v[3]};
}
// A transposition of 4 x 4.
CREVICE_INLINE TextureColour<Wide<4>> channels_of(const Rgba<Wide<4>> (&rgba)[4]) {
    using V = Wide<4>::V;
    const V rg01 = __builtin_shufflevector(rgba[0].v, rgba[1].v, 0, 4, 1, 5),
            rg23 = __builtin_shufflevector(rgba[2].v, rgba[3].v, 0, 4, 1, 5),
            ba01 = __builtin_shufflevector(rgba[0].v, rgba[1].v, 2, 6, 3, 7),
            ba23 = __builtin_shufflevector(rgba[2].v, rgba[3].v, 2, 6, 3, 7);
    return {{Wide<4>(__builtin_shufflevector(rg01, rg23, 0, 1, 4, 5)),
             Wide<4>(__builtin_shufflevector(rg01, rg23, 2, 3, 6, 7)),
             Wide<4>(__builtin_shufflevector(ba01, ba23, 0, 1, 4, 5))},
            Wide<4>(__builtin_shufflevector(ba01, ba23, 2, 3, 6, 7))};
}
// Two of them, side by side.
CREVICE_INLINE TextureColour<Wide<8>> channels_of(const Rgba<Wide<8>> (&rgba)[4]) {
    using V = Wide<8>::V;
    const V rg01 = __builtin_shufflevector(rgba[0].v, rgba[1].v, 0, 8, 1, 9, 4, 12, 5, 13),
            rg23 = __builtin_shufflevector(rgba[2].v, rgba[3].v, 0, 8, 1, 9, 4, 12, 5, 13),
            ba01 = __builtin_shufflevector(rgba[0].v, rgba[1].v, 2, 10, 3, 11, 6, 14, 7, 15),
            ba23 = __builtin_shufflevector(rgba[2].v, rgba[3].v, 2, 10, 3, 11, 6, 14, 7, 15);
    return {{Wide<8>(__builtin_shufflevector(rg01, rg23, 0, 1, 8, 9, 4, 5, 12, 13)),
             Wide<8>(__builtin_shufflevector(rg01, rg23, 2, 3, 10, 11, 6, 7, 14, 15)),
             Wide<8>(__builtin_shufflevector(ba01, ba23, 0, 1, 8, 9, 4, 5, 12, 13))},
            Wide<8>(__builtin_shufflevector(ba01, ba23, 2, 3, 10, 11, 6, 7, 14, 15))};
}

}  // namespace crevice
