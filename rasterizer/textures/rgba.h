// Texels of textures: in memory the four channels lie side by side, and filters mix them as they lie.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "rasterizer/lanes/vec3.h"
#include "rasterizer/lanes/wide_fours.h"

namespace crevice {

// RGBA as whole numbers from 0 to kTexelOne, which stands for 1. This one because every code of 8 bits and every
// 256th is a whole number of it: level normals, opaque alpha and data of 8 bits are stored exactly.
using Rgba16 = std::array<std::uint16_t, 4>;
inline constexpr float kTexelOne = 255 * 256;

template <class F>
using Rgba = Fours<F>;

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

// Sorted by channel.
template <class F>
struct TextureColour {
    Vec3<F> colour;  // linear light, [0,1]
    F alpha;         // [0,1]; 1 where the texture has none
};
template <class F>
CREVICE_INLINE TextureColour<F> channels_of(const Rgba<F> (&rgba)[kFours<F>]) {
    const std::array<F, 4> channels = sorted(rgba);
    return {{channels[0], channels[1], channels[2]}, channels[3]};
}

}  // namespace crevice
