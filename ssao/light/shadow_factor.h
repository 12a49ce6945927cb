// How much of the light reaches a point: 3x3 percentage-closer filtering (Reeves, Salesin, Cook 1987) as both
// tutorials do it with the hardware's comparison sampler.
//
// Nine taps, one texel apart, are averaged. Each tap compares the point's depth with four texels and weighs
// the four answers bilinearly, with weights of 8 bits (D3D11.3 functional spec 7.18.8). Neighbouring taps
// share their texels, so the nine are one sum over 4x4 texels with weights 1 - f, 1, 1, f along each axis.
// That sum is exact; one division follows: fully lit is exactly 1, fully shadowed exactly 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec4.hpp>

#include "rasterizer/draw/depth_buffer.h"
#include "rasterizer/lanes/wide_fours.h"
#include "rasterizer/spaces.h"
#include "ssao/light/shadow_map.h"

namespace crevice {

// A shadow map as one view reads it: the way from view space to the map's texels, found in double from the
// two eyes' difference, so that a scene far from the world's origin loses nothing.
struct ShadowLookup {
    const ShadowMap& map;
    glm::vec4 column, row, depth;  // of (p_view, 1): in texels, in texels, ndc
};
ShadowLookup shadow_lookup(const ShadowMap& map, const Camera& view);

// The least code in the map that leaves a point of this ndc depth lit. Codes are compared as the real numbers
// they stand for, the point's depth unrounded; of a UNORM map it is clamped to [0,1] first, as hardware does,
// so that beyond the far plane LESS_EQUAL meets 1 and is lit. NaN counts as beyond the far plane.
template <class F>
CREVICE_INLINE Int<F> least_lit_code(const ShadowSettings& settings, F z_ndc) {
    const bool or_equal = settings.comparison == DepthFunction::less_equal;
    const F z = z_ndc - F(settings.shader_bias);
    const F from_near = select(z <= F(0), F(0), min_of(z, F(2)));  // NaN becomes 2
    if (settings.format == DepthFormat::d32f) {
        return or_equal ? float_bits(from_near) : float_bits(from_near) + Int<F>(1);
    }
    const double steps = settings.format == DepthFormat::d16 ? kD16Steps : kD24Steps;
    // Exact: 24 bits times 24.
    const Double<F> in_steps = to_double(min_of(from_near, F(1))) * Double<F>(steps);
    const Int<F> whole = to_int(in_steps);
    if (!or_equal) return whole + Int<F>(1);
    return select(to_double(whole) < in_steps, whole + Int<F>(1), whole);
}

// How many texels the taps share along each axis.
inline constexpr int kShadowTexels = 4;
// Those from (column, row) on, row by row: in the map its codes, beyond it the border.
void copy_shadow_texels(const ShadowMap& map, int column, int row, std::int32_t* texels);

// In [0,1]: 1 lit, 0 in shadow. p_view is where the surface is in the view's space. Points beyond the map's
// edge meet the border; a coordinate that is NaN counts as beyond.
template <class F>
CREVICE_INLINE F shadow_factor(const ShadowLookup& lookup, Vec3<F> p_view) {
    using I = Int<F>;
    const Image<std::int32_t>& codes = lookup.map.depth.codes;
    const ShadowSettings& settings = lookup.map.settings;
    const auto along = [&](const glm::vec4& m) __attribute__((always_inline)) {
        return F(m.x) * p_view.x + F(m.y) * p_view.y + F(m.z) * p_view.z + F(m.w);
    };
    const I least_lit = least_lit_code(settings, along(lookup.depth));

    // The middle tap's upper left texel in 1/256 texel, at most 4 texels outside the map.
    const float side = static_cast<float>(codes.size.width);
    const auto in_steps = [&](F at) __attribute__((always_inline)) {
        const F near_map = min_of(max_of(at - F(0.5f), F(-4)), F(side + 3));
        return round_half_even(near_map * F(static_cast<float>(kSubpixelSteps)));
    };
    const I x_steps = in_steps(along(lookup.column)), y_steps = in_steps(along(lookup.row));
    const I x0 = (x_steps >> kSubpixelBits) - I(1), y0 = (y_steps >> kSubpixelBits) - I(1);
    const auto fraction = [](I at) __attribute__((always_inline)) {
        return F(to_float(at & I(kSubpixelSteps - 1))) * F(1.0f / kSubpixelSteps);
    };
    // Where each lane's first texel lies. If one reaches beyond the map, all have copies of their texels, with the border.
    std::int32_t first[kLanes<F>], copies[kLanes<F> * kShadowTexels * kShadowTexels];
    const std::int32_t* texels = codes.pixels.data();
    std::ptrdiff_t stride = codes.stride;
    const I zero(0), last_first(codes.size.width - kShadowTexels);
    if (any((x0 < zero) | (y0 < zero) | (x0 > last_first) | (y0 > last_first))) {
        std::int32_t column[kLanes<F>], row[kLanes<F>];
        store(column, x0);
        store(row, y0);
        for (int lane = 0; lane < kLanes<F>; ++lane) {
            first[lane] = kShadowTexels * kShadowTexels * lane;
            copy_shadow_texels(lookup.map, column[lane], row[lane], copies + first[lane]);
        }
        texels = copies;
        stride = kShadowTexels;
    } else {
        store(first, y0 * I(codes.stride) + x0);
    }

    // Row by row as the texels lie in memory: what the four columns add up to.
    const F fx = fraction(x_steps), fy = fraction(y_steps);
    Fours<F, std::int32_t> least[kFours<F>];
    Fours<F> upper_weight[kFours<F>], lower_weight[kFours<F>], columns[kFours<F>];
    spread_to_fours(least_lit, least);
    spread_to_fours(F(1) - fy, upper_weight);
    spread_to_fours(fy, lower_weight);
    for (int k = 0; k < kFours<F>; ++k) {
        using V = typename Fours<F>::V;
        const auto row = [&](int j, V weight) __attribute__((always_inline)) {
            const Fours<F, std::int32_t> stored = gather_fours<F>(texels + j * stride, first + k);
            return stored.v >= least[k].v ? weight : V{};
        };
        const V whole = V{} + 1;
        columns[k].v = row(0, upper_weight[k].v) + row(1, whole) + row(2, whole) + row(3, lower_weight[k].v);
    }
    const std::array<F, 4> sum = sorted(columns);
    return ((F(1) - fx) * sum[0] + sum[1] + sum[2] + fx * sum[3]) / F(9);
}

}  // namespace crevice
