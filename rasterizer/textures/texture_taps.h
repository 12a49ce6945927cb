// Which texels a bilinear lookup mixes, and their mixture.
#pragma once

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

// Stands for the border colour in place of a texel's index.
inline constexpr float kBorder = -1;

// The texel that an index from -1 to `last` + 1 stands for (border: any index). Whole numbers.
template <class F>
CREVICE_INLINE F texel_at(F index, float last, AddressMode mode) {
    const bool wraps = mode == AddressMode::wrap, clamps = mode == AddressMode::clamp;
    const float below = wraps ? last : clamps ? 0 : kBorder, above = wraps ? 0 : clamps ? last : kBorder;
    return select(index < F(0), F(below), select(index > F(last), F(above), index));
}

// One axis of a lookup: two texels, and the second one's share.
template <class F>
struct AxisTaps {
    Int<F> first, second;
    F share;
};

// From a coordinate that is in_range, on a side of so many texels.
template <class F>
CREVICE_INLINE AxisTaps<F> taps_at(F coordinate, int texels, AddressMode mode, bool nearest) {
    const float last = static_cast<float>(texels - 1);
    const F zero = F(0), one = F(1);
    const F x = coordinate * F(static_cast<float>(texels)) - F(nearest ? 0.0f : 0.5f);
    const F toward_zero = from_int<F>(to_int(x)), rest = x - toward_zero;
    const F carry = select(rest < zero, one, zero);
    const F below = toward_zero - carry, first = texel_at(below, last, mode);
    const F second = nearest ? first : texel_at(below + one, last, mode);
    return {to_int(first), to_int(second), nearest ? zero : rest + carry};
}

// A bilinear lookup of one level by each lane, in any texture of the same size.
template <class F>
struct LevelTaps {
    // Where in texels(), below 0 for the border. In memory, because texels are fetched lane by lane.
    std::int32_t upper_left[kLanes<F>], upper_right[kLanes<F>], lower_left[kLanes<F>], lower_right[kLanes<F>];
    Rgba<F> right_share[kRgbas<F>], lower_share[kRgbas<F>];

    // `at` is in_range.
    CREVICE_INLINE LevelTaps(const Texture::Level& level, Vec2<F> at, Addressing addressing) {
        const AxisTaps<F> columns = taps_at<F>(at.x, level.size.width, addressing.u, addressing.nearest),
                          rows = taps_at<F>(at.y, level.size.height, addressing.v, addressing.nearest);
        const Int<F> stride(level.stride), first(level.first);
        const auto place = [&](std::int32_t * index, Int<F> row, Int<F> column)
            __attribute__((always_inline)) {
            const Int<F> inside = (first + row * stride) + (column << 2);
            const bool border = addressing.has_border();
            store(index, border ? select((row | column) < Int<F>(0), Int<F>(-1), inside) : inside);
        };
        place(upper_left, rows.first, columns.first);
        place(upper_right, rows.first, columns.second);
        place(lower_left, rows.second, columns.first);
        place(lower_right, rows.second, columns.second);
        spread_to_channels(columns.share, right_share);
        spread_to_channels(rows.share, lower_share);
    }

    // Of the lanes that Rgba number `i` stands for. `border` is null where the addressing knows none.
    CREVICE_INLINE Rgba<F> mixed(const float* texels, const float* border, int i) const {
        const Rgba<F> above = mix(gather_rgba<F>(texels, upper_left + i, border),
                                  gather_rgba<F>(texels, upper_right + i, border), right_share[i]),
                      below = mix(gather_rgba<F>(texels, lower_left + i, border),
                                  gather_rgba<F>(texels, lower_right + i, border), right_share[i]);
        return mix(above, below, lower_share[i]);
    }
};

}  // namespace crevice
