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
    using Numbers = Wide<kElements<typename Rgba<F>::V>>;
    return {select(Numbers(where.v) > Numbers(0), Numbers(a.v), Numbers(b.v)).v};
}
template <class F>
CREVICE_INLINE Rgba<F> over_all_pixels(const float* rgba) {
    Wide<4>::V v;
    std::memcpy(&v, rgba, sizeof v);
    return {joined_fours<F>([&](int) __attribute__((always_inline)) { return v; })};
}

// Two texels that lie side by side, in units of 1 / kTexelOne.
template <class F>
struct TexelPair {
    Rgba<F> left, right;
};

typedef std::uint16_t TwoTexels __attribute__((vector_size(16)));
typedef std::uint16_t FourTexels __attribute__((vector_size(32)));
typedef std::uint16_t EightTexels __attribute__((vector_size(64)));

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

CREVICE_INLINE TexelPair<Wide<16>> unpacked(EightTexels codes) {
    using Words = WideInt<16>::V;
    const EightTexels zero = {};
    const auto left = __builtin_shufflevector(codes, zero, 0, 32, 1, 33, 2, 34, 3, 35, 8, 40, 9, 41, 10, 42,
                                              11, 43, 16, 48, 17, 49, 18, 50, 19, 51, 24, 56, 25, 57, 26, 58,
                                              27, 59),
               right = __builtin_shufflevector(codes, zero, 4, 36, 5, 37, 6, 38, 7, 39, 12, 44, 13, 45, 14,
                                               46, 15, 47, 20, 52, 21, 53, 22, 54, 23, 55, 28, 60, 29, 61, 30,
                                               62, 31, 63);
    return {{to_float(WideInt<16>(__builtin_bit_cast(Words, left))).v},
            {to_float(WideInt<16>(__builtin_bit_cast(Words, right))).v}};
}

// The pairs that begin at base[index[0]] and, of more than four lanes, base[index[4]] and so on. No index is below 0.
template <class F>
CREVICE_INLINE TexelPair<F> gather_pair(const Rgba16* base, const std::int32_t* index) {
    const auto bits = joined_fours<F>([&](int lane) __attribute__((always_inline)) {
        VectorOf<std::int64_t, 2>::type pair;
        // Unsigned, because that needs no sign extension.
        std::memcpy(&pair, base + static_cast<std::uint32_t>(index[lane]), sizeof pair);
        return pair;
    });
    if constexpr (kLanes<F> == 16) {
        return unpacked(__builtin_bit_cast(EightTexels, bits));
    } else if constexpr (kLanes<F> == 8) {
        return unpacked(__builtin_bit_cast(FourTexels, bits));
    } else {
        const TexelPair<float> two = unpacked(__builtin_bit_cast(TwoTexels, bits));
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
