// Which pairs of texels count for each other in the bilateral blur.
//
// Counting is mutual, to the last bit, so each pair is decided once: by the left or the upper texel, for both the tap
// of one, 5 + j, and that of the other, 5 - j.
#pragma once

#include <algorithm>
#include <array>

#include "ssao/blur/blur_rows.h"

namespace crevice {

constexpr std::int32_t pair_bits(int shift, int j) {
    return tap_bit(shift, kBlurRadius - j) | tap_bit(shift, kBlurRadius + j);
}

// The texels of row y, and their pairs with the five neighbours to the right and below.
class BlurPairs {
 public:
    BlurPairs(const AoInputs& inputs, const BlurRays& rays, const BlurSettings& settings, int y)
        : rays_(rays),
          settings_(settings),
          size_(inputs.size()),
          y_(y),
          rows_below_(std::min(kBlurRadius, size_.height - 1 - y)),
          stride_(inputs.view_depth.stride),
          row_{inputs.normal.x.row(y), inputs.normal.y.row(y), inputs.normal.z.row(y),
               inputs.view_depth.row(y)},
          end_first_(std::max(0, round_up(size_.width, kRowAlignment) - kRowEnd)) {
        view_depth_.fill(kNoSurface);
        const int count = size_.width - end_first_;
        std::copy_n(row_.normal_x + end_first_, count, normal_x_.begin());
        std::copy_n(row_.normal_y + end_first_, count, normal_y_.begin());
        std::copy_n(row_.normal_z + end_first_, count, normal_z_.begin());
        std::copy_n(row_.view_depth + end_first_, count, view_depth_.begin());
    }

    // Whether one of the texels from x on shows a surface.
    template <class F>
    CREVICE_INLINE bool any_surface(int x) const {
        const RowFrom texels = from<F>(x);
        return any(load<F>(texels.row.view_depth + texels.x) < F(kNoSurface));
    }

    // The pair bits of the texels from x on, as the settings' edges have it.
    template <class F>
    CREVICE_INLINE Int<F> bits(int x) const {
        const Thresholds least = {settings_.normal_threshold, settings_.depth_threshold};
        if (settings_.edges == BlurEdges::none) {
            const Int<F> column = lane_index<F>() + Int<F>(x), width(size_.width);
            return pairs_where<F>(
                [&](auto j) __attribute__((always_inline)) { return column + Int<F>(j) < width; },
                [&](auto) __attribute__((always_inline)) { return column < width; });
        }
        const RowFrom across = from<F>(x);
        const BlurSurface<F> centre = surface_at<F>(across.row, across.x);
        const auto to_the_right = [&](int j) __attribute__((always_inline)) {
            return surface_at<F>(across.row, across.x + j);
        };
        const auto below = [&](int j) __attribute__((always_inline)) {
            return surface_at<F>(row_, x + j * stride_);
        };
        if (settings_.edges == BlurEdges::slope) {
            const Vec3<F> p_view = rays_.p_view<F>(x, y_, centre.view_depth);
            const auto on_plane = [&](const BlurSurface<F>& other, int column, int other_row)
                __attribute__((always_inline)) {
                const Vec3<F> other_view = rays_.p_view<F>(column, other_row, other.view_depth);
                return counts_on_slope<F>(centre, p_view, other, other_view, least);
            };
            return pairs_where<F>(
                [&](auto j) __attribute__((always_inline)) { return on_plane(to_the_right(j), x + j, y_); },
                [&](auto j) __attribute__((always_inline)) { return on_plane(below(j), x, y_ + j); });
        }
        return pairs_where<F>(
            [&](auto j) __attribute__((always_inline)) { return counts<F>(centre, to_the_right(j), least); },
            [&](auto j) __attribute__((always_inline)) { return counts<F>(centre, below(j), least); });
    }

 private:
    // Texels of a row from x on, with what follows them.
    struct RowFrom {
        BlurRow row;
        int x;
    };
    // What follows the map's last texel is no part of it: there the row's end is read, where it has no surface.
    template <class F>
    CREVICE_INLINE RowFrom from(int x) const {
        if (x + kLanes<F> + kBlurRadius <= size_.width) return {row_, x};
        return {{normal_x_.data(), normal_y_.data(), normal_z_.data(), view_depth_.data()}, x - end_first_};
    }

    // across(j) and down(j) are whether the texels and their j-th neighbours count for each other. j is a compile-time
    // constant.
    template <class F, class Across, class Down>
    CREVICE_INLINE Int<F> pairs_where(const Across& across, const Down& down) const {
        Int<F> bits(0);
        each_tap([&](auto k) __attribute__((always_inline)) {
            if constexpr (k > kBlurRadius) {
                constexpr std::integral_constant<int, k - kBlurRadius> j;
                bits = bits | select(across(j), Int<F>(pair_bits(kAcrossShift, j)), Int<F>(0));
                if (j <= rows_below_)
                    bits = bits | select(down(j), Int<F>(pair_bits(kDownShift, j)), Int<F>(0));
            }
        });
        return bits;
    }

    // Every group of texels that reaches beyond the map begins in the row's end.
    static constexpr int kRowEnd = round_up(kRowAlignment + kMostLanes + kBlurRadius, kRowAlignment);
    using RowEnd = std::array<float, kRowEnd + kRowAlignment>;
    static_assert(kBlurRadius <= kRowAlignment);

    const BlurRays& rays_;
    const BlurSettings& settings_;
    const Size size_;
    const int y_, rows_below_;
    const std::ptrdiff_t stride_;
    const BlurRow row_;
    const int end_first_;
    RowEnd normal_x_{}, normal_y_{}, normal_z_{}, view_depth_;
};

}  // namespace crevice
