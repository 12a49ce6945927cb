// Texels as they lie in memory, the four channels side by side: a filter mixes them without sorting them by
// channel first, since all four take the same arithmetic.
#pragma once

#include <cstring>

#include "rasterizer/lanes/vec3.h"

namespace crevice {

// RGBA of one pixel (F = float or Wide<4>), or of two pixels (Wide<8>): of lane i in the lower half and of lane
// i + 4 in the upper one. So four lanes and eight are four of these, and one lane is one.
template <class F>
struct Rgba {
    using V = Wide<4>::V;
    V v;
};
template <>
struct Rgba<Wide<8>> {
    Wide<8>::V v;
};
template <class F>
inline constexpr int kRgbas = kLanes<F> == 1 ? 1 : 4;

// As mix of wide.h, channel by channel.
template <class F>
CREVICE_INLINE Rgba<F> mix(Rgba<F> a, Rgba<F> b, Rgba<F> t) {
    return {a.v + t.v * (b.v - a.v)};
}

CREVICE_INLINE Rgba<float>::V load_four(const float* at) {
    Rgba<float>::V v;
    std::memcpy(&v, at, sizeof v);
    return v;
}

// The texels that begin at base[index[0]] and, of eight lanes, base[index[4]]; for an index below 0 it is *outside.
template <class F>
CREVICE_INLINE Rgba<F> gather_rgba(const float* base, const std::int32_t* index, const float* outside) {
    const auto texel = [&](std::int32_t i) __attribute__((always_inline)) {
        return load_four(outside != nullptr && i < 0 ? outside : base + i);
    };
    if constexpr (kLanes<F> == 8) {
        return {joined(texel(index[0]), texel(index[4]))};
    } else {
        return {texel(index[0])};
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
