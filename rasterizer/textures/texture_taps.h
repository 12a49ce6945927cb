// Which texels a bilinear lookup mixes, and their mixture.
#pragma once

#include <cstddef>

#include "rasterizer/textures/rgba.h"
#include "rasterizer/textures/sampler.h"
#include "rasterizer/textures/texture.h"
#include "rasterizer/textures/texture_footprint.h"

namespace crevice {

// What of a Sampler matters to a lookup of one level.
struct Addressing {
    AddressMode u = AddressMode::wrap, v = AddressMode::wrap;
    bool nearest = false;  // one texel instead of four

    bool has_border() const { return u == AddressMode::border || v == AddressMode::border; }
    friend bool operator==(const Addressing&, const Addressing&) = default;
};

// A coordinate in the range in which it still makes a difference: [0,1] for wrap, so that whole repeats cost
// no precision, and for clamp; [-1,2] for border, where every level has come to the border alone.
template <class F>
CREVICE_INLINE F in_range(F coordinate, AddressMode mode) {
    const F zero = F(0);
    if (mode == AddressMode::clamp) return saturate(coordinate);
    if (mode == AddressMode::border) {
        return select(coordinate == coordinate, min_of(max_of(coordinate, F(-1)), F(2)), zero);
    }
    // From 2^23 on every float is whole.
    const F fractional = select(absolute(coordinate) < F(0x1p23f), coordinate, zero);
    const F fraction = fractional - from_int<F>(to_int(fractional));
    return select(fraction < zero, fraction + F(1), fraction);
}
template <class F>
CREVICE_INLINE Vec2<F> in_range(Vec2<F> uv, Addressing addressing) {
    return {in_range(uv.x, addressing.u), in_range(uv.y, addressing.v)};
}

// One axis of a lookup: two neighbours and the second one's share.
template <class F>
struct AxisTaps {
    Int<F> first;             // its neighbour follows it in memory: see Texture::Level
    F share;                  // of the neighbour
    F has_first, has_second;  // with a border: 1, or 0 where the border stands for it
};

// From a coordinate that is in_range, on a side of so many texels.
template <class F>
CREVICE_INLINE AxisTaps<F> taps_at(F coordinate, int texels, AddressMode mode, bool nearest) {
    const F zero = F(0), one = F(1), last(static_cast<float>(texels - 1));
    const F x = coordinate * F(static_cast<float>(texels)) - F(nearest ? 0.0f : 0.5f);
    const F toward_zero = from_int<F>(to_int(x)), rest = x - toward_zero;
    const F carry = select(rest < zero, one, zero);
    const F below = toward_zero - carry, share = nearest ? zero : rest + carry;
    const Mask<F> before = below < zero;
    const Mask<F> behind = below > last;
    if (mode == AddressMode::clamp) {
        // What is clamped has no neighbour.
        const F first = select(before, zero, select(behind, last, below));
        return {to_int(first), select(before | (below >= last), zero, share), one, one};
    }
    // Of a wrapped coordinate only the nearest texel can lie behind the last.
    const bool bounded = mode == AddressMode::wrap && !nearest;
    const Int<F> first = to_int(select(before, last, bounded ? below : select(behind, zero, below)));
    if (mode == AddressMode::wrap) return {first, share, one, one};
    return {first, share, select(before | behind, zero, one),
            select((below < zero - one) | (below >= last), zero, one)};
}

// A bilinear lookup of one level by each lane, in any texture of the same size.
template <class F>
struct LevelTaps {
    std::ptrdiff_t stride;
    std::int32_t upper_left[kLanes<F>];  // in texels(). In memory, because texels are fetched lane by lane.
    Rgba<F> right_share[kFours<F>], lower_share[kFours<F>];
    // With a border: which columns and rows are the texture's, 1 or 0.
    Rgba<F> has_left[kFours<F>], has_right[kFours<F>], has_upper[kFours<F>], has_lower[kFours<F>];

    // `at` is in_range.
    CREVICE_INLINE LevelTaps(const Texture::Level& level, Vec2<F> at, Addressing addressing)
        : stride(level.stride) {
        const AxisTaps<F> columns = taps_at<F>(at.x, level.size.width, addressing.u, addressing.nearest),
                          rows = taps_at<F>(at.y, level.size.height, addressing.v, addressing.nearest);
        store(upper_left, (Int<F>(level.first) + rows.first * Int<F>(level.stride)) + columns.first);
        spread_to_fours(columns.share, right_share);
        spread_to_fours(rows.share, lower_share);
        if (!addressing.has_border()) return;
        spread_to_fours(columns.has_first, has_left);
        spread_to_fours(columns.has_second, has_right);
        spread_to_fours(rows.has_first, has_upper);
        spread_to_fours(rows.has_second, has_lower);
    }

    // Of the lanes that Rgba number `i` stands for, in units of 1 / kTexelOne. `border`, in these units, is null
    // where the addressing knows none.
    CREVICE_INLINE Rgba<F> mixed(const Rgba16* texels, const float* border, int i) const {
        TexelPair<F> upper = gather_pair<F>(texels, upper_left + i),
                     lower = gather_pair<F>(texels + stride, upper_left + i);
        if (border != nullptr) {
            const Rgba<F> outside = over_all_pixels<F>(border);
            upper = chosen_pair(has_upper[i], upper, outside, i);
            lower = chosen_pair(has_lower[i], lower, outside, i);
        }
        return mix(mix(upper.left, upper.right, right_share[i]), mix(lower.left, lower.right, right_share[i]),
                   lower_share[i]);
    }

 private:
    CREVICE_INLINE TexelPair<F> chosen_pair(Rgba<F> has_row, TexelPair<F> pair, Rgba<F> outside,
                                            int i) const {
        return {chosen(has_row, chosen(has_left[i], pair.left, outside), outside),
                chosen(has_row, chosen(has_right[i], pair.right, outside), outside)};
    }
};

}  // namespace crevice
