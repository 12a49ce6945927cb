// The bilateral blur of one band of rows: one sweep down the map does all passes of all iterations.
//
// When the taps of row y are decided, the first pass across can do row y. A pass down reads five rows below
// its own, so it does row y - 5; of that row the second iteration's pass across is next, and so on: each
// iteration follows five rows behind the one before. A few rows of each pass are enough, and they stay in the
// cache. What a band reads of its neighbours' passes it computes itself, so that bands need not wait for each
// other.
#pragma once

#include <algorithm>
#include <vector>

#include "ssao/blur/blur_rows.h"

namespace crevice {

// The rows of a map that are still needed, row y in place of row y - capacity. At both ends of a row lie
// texels outside the map, so that no tap needs a test of its position.
template <class T>
class RowRing {
 public:
    RowRing(int width, int capacity, T fill)
        : capacity_(capacity), rows_({kApron + width + kApron, capacity}, fill) {}
    // Texel 0 of row y; y >= -capacity.
    T* row(int y) { return rows_.row((y + capacity_) % capacity_) + kApron; }

 private:
    static constexpr int kApron = kRowAlignment;
    static_assert(kApron >= kBlurRadius);
    int capacity_;
    Image<T> rows_;
};

struct Rows {
    int first, end;

    bool contains(int y) const { return first <= y && y < end; }
    Rows grown(int by, int height) const { return {std::max(0, first - by), std::min(height, end + by)}; }
};

// What all bands of a sweep share.
struct BlurSweep {
    const Image<float>& ao;
    const AoInputs& inputs;
    const BlurRays& rays;
    const BlurSettings& settings;
    int iterations;             // of this sweep
    const TileMap& open_tiles;  // without tiles: none is open
    bool skips_background;

    Size size() const { return ao.size; }
    int width() const { return round_up(ao.size.width, kRowAlignment); }  // of the rows worked on
    int reach() const { return iterations * kBlurRadius; }

    // Whether the tile with texel (x, y) is left at 1; for a texel outside the map, the nearest tile.
    bool is_open(int x, int y) const {
        if (open_tiles.tiles.empty()) return false;
        const int column = std::min(x, ao.size.width - 1) / kBlurTile;
        const int row = std::min(y, ao.size.height - 1) / kBlurTile;
        return open_tiles.tiles.at(column, row) == TileWork::open;
    }
};

// The rows that a band is working on, and the steps of the sweep.
class BlurBand {
 public:
    explicit BlurBand(const BlurSweep& sweep)
        : sweep_(sweep),
          normal_x_(sweep.width(), 1, 0.0f),
          normal_y_(sweep.width(), 1, 0.0f),
          normal_z_(sweep.width(), 1, 0.0f),
          view_depth_(sweep.width(), 1, kNoSurface),
          pairs_(sweep.width(), kBlurRadius + 1, 0),
          bits_(sweep.width(), sweep.reach() + 1, 0),
          total_across_(sweep.width(), sweep.reach() + 1, 1.0f),
          total_down_(sweep.width(), sweep.reach() + 1, 1.0f),
          group_across_(sweep.width() / kSmallestBlurGroup, sweep.reach() + 1, GroupTaps::none),
          group_down_(sweep.width() / kSmallestBlurGroup, sweep.reach() + 1, GroupTaps::none),
          source_(sweep.width(), 1, 0.0f),
          across_(static_cast<std::size_t>(sweep.iterations),
                  RowRing<float>(sweep.width(), kBlurTaps, 0.0f)) {}

    // Blurs the rows `own` into `result`.
    template <class F>
    CREVICE_INLINE void sweep_down(Rows own, Image<float>& result) {
        const int height = sweep_.size().height, reach = sweep_.reach();
        const Rows read = own.grown(reach, height);
        for (int step = read.first; step < own.end + reach; ++step) {
            if (read.contains(step)) {
                // The pairs of the next step read one row more, which is far away in each plane.
                const AoInputs& in = sweep_.inputs;
                for (const Image<float>* plane :
                     {&in.normal.x, &in.normal.y, &in.normal.z, &in.view_depth, &sweep_.ao})
                    expect_next_row(*plane, 0, sweep_.width(), step + kBlurRadius);
                decide_pairs<F>(step);
                decide_taps<F>(step);
                std::copy_n(sweep_.ao.row(step), sweep_.width(), source_.row(0));
            }
            for (int i = 0; i < sweep_.iterations; ++i) {
                // The passes that follow still reach this far beyond the band.
                const int after_across = reach - i * kBlurRadius, after_down = after_across - kBlurRadius;
                const int y_across = step - i * kBlurRadius, y_down = y_across - kBlurRadius;
                const bool last = i + 1 == sweep_.iterations;
                RowRing<float>& across = across_[static_cast<std::size_t>(i)];
                if (own.grown(after_across, height).contains(y_across)) blur_across<F>(across, y_across);
                if (own.grown(after_down, height).contains(y_down))
                    blur_down<F>(across, y_down, last ? result.row(y_down) : source_.row(0));
            }
        }
    }

 private:
    // Pair bits of row y. Above the first row of a band none are known: the taps of its first five rows down
    // are incomplete there, and no pass down does these rows, unless the map begins with them.
    template <class F>
    CREVICE_INLINE void decide_pairs(int y) {
        const AoInputs& inputs = sweep_.inputs;
        const BlurRow row = {inputs.normal.x.row(y), inputs.normal.y.row(y), inputs.normal.z.row(y),
                             inputs.view_depth.row(y)};
        const BlurRow padded = padded_copy(row);
        const int rows_below = std::min(kBlurRadius, sweep_.size().height - 1 - y);
        const bool needs_surface = sweep_.settings.edges != BlurEdges::none;
        std::int32_t* pairs = pairs_.row(y);
        for (int tile = 0; tile < sweep_.width(); tile += kBlurTile) {
            // A tile's pairs are also read to its right and below.
            const bool unread = sweep_.is_open(tile, y) && sweep_.is_open(tile + kBlurTile, y) &&
                                sweep_.is_open(tile, y + kBlurRadius);
            for (int x = tile; x < std::min(tile + kBlurTile, sweep_.width()); x += kLanes<F>) {
                const bool surface = any(load<F>(padded.view_depth + x) < F(kNoSurface));
                const bool none = unread || (!surface && sweep_.skips_background && needs_surface);
                store(pairs + x, none ? Int<F>(0) : pairs_at<F>(padded, row, y, rows_below, x));
            }
        }
    }

    // The pair bits of the texels of row y from x on, as the settings' edges have it. `padded` is the row
    // with kBlurRadius texels more at its right end that have no surface; `row` is where it lies in the map.
    template <class F>
    CREVICE_INLINE Int<F> pairs_at(const BlurRow& padded, const BlurRow& row, int y, int rows_below, int x) {
        const Thresholds least = {sweep_.settings.normal_threshold, sweep_.settings.depth_threshold};
        const std::ptrdiff_t stride = sweep_.inputs.view_depth.stride;
        if (sweep_.settings.edges == BlurEdges::none) {
            const Int<F> column = lane_index<F>() + Int<F>(x), width(sweep_.size().width);
            return pairs_where<F>(
                [&](auto j) __attribute__((always_inline)) { return column + Int<F>(j) < width; },
                [&](auto) __attribute__((always_inline)) { return column < width; }, rows_below);
        }
        const BlurSurface<F> centre = surface_at<F>(padded, x);
        if (sweep_.settings.edges == BlurEdges::slope) {
            const Vec3<F> p_view = sweep_.rays.p_view<F>(x, y, centre.view_depth);
            const auto on_plane = [&](const BlurSurface<F>& other, int column, int other_row)
                __attribute__((always_inline)) {
                const Vec3<F> other_view = sweep_.rays.p_view<F>(column, other_row, other.view_depth);
                return counts_on_slope<F>(centre, p_view, other, other_view, least);
            };
            return pairs_where<F>(
                [&](auto j) __attribute__((always_inline)) {
                    return on_plane(surface_at<F>(padded, x + j), x + j, y);
                },
                [&](auto j) __attribute__((always_inline)) {
                    return on_plane(surface_at<F>(row, x + j * stride), x, y + j);
                },
                rows_below);
        }
        return pairs_where<F>(
            [&](auto j) __attribute__((always_inline)) {
                return counts<F>(centre, surface_at<F>(padded, x + j), least);
            },
            [&](auto j) __attribute__((always_inline)) {
                return counts<F>(centre, surface_at<F>(row, x + j * stride), least);
            },
            rows_below);
    }

    // The row with texels beyond its right end that have no surface.
    CREVICE_INLINE BlurRow padded_copy(const BlurRow& row) {
        const int width = sweep_.size().width;
        std::copy_n(row.normal_x, width, normal_x_.row(0));
        std::copy_n(row.normal_y, width, normal_y_.row(0));
        std::copy_n(row.normal_z, width, normal_z_.row(0));
        std::copy_n(row.view_depth, width, view_depth_.row(0));
        return {normal_x_.row(0), normal_y_.row(0), normal_z_.row(0), view_depth_.row(0)};
    }

    // From the pair bits of row y and of the five above it.
    template <class F>
    CREVICE_INLINE void decide_taps(int y) {
        PairRows pairs;
        for (int j = 0; j <= kBlurRadius; ++j) pairs[static_cast<std::size_t>(j)] = pairs_.row(y - j);
        const TapRow across = taps_across(y), down = taps_down(y);
        const BlurWeights weights = sweep_.settings.weights;
        const F total_of_all = total_weight<F>(Int<F>(all_taps(kAcrossShift)), kAcrossShift, weights);
        const bool may_keep = sweep_.skips_background;
        for (int tile = 0; tile < sweep_.width(); tile += kBlurTile) {
            const bool open = sweep_.is_open(tile, y);
            for (int x = tile; x < std::min(tile + kBlurTile, sweep_.width()); x += kBlurGroup<F>) {
                if (open) {
                    across.group[x / kBlurGroup<F>] = down.group[x / kBlurGroup<F>] = GroupTaps::none;
                } else {
                    decide_bits<F>(pairs, bits_.row(y), x);
                    decide_group<F>(across, x, kAcrossShift, weights, total_of_all, may_keep);
                    decide_group<F>(down, x, kDownShift, weights, total_of_all, may_keep);
                }
            }
        }
    }

    template <class F>
    CREVICE_INLINE void blur_across(RowRing<float>& across, int y) {
        const float* centre = source_.row(0);
        const auto row_of_tap = [=](auto k) __attribute__((always_inline)) {
            return centre + (k - kBlurRadius);
        };
        blur_row<F>(row_of_tap, taps_across(y), kAcrossShift, sweep_.settings, across.row(y), sweep_.width());
    }

    template <class F>
    CREVICE_INLINE void blur_down(RowRing<float>& across, int y, float* result) {
        std::array<const float*, kBlurTaps> rows;
        for (int k = 0; k < kBlurTaps; ++k) {
            // Rows outside the map never count: any will do.
            const int row = std::clamp(y + k - kBlurRadius, 0, sweep_.size().height - 1);
            rows[static_cast<std::size_t>(k)] = across.row(row);
        }
        const auto row_of_tap = [&](auto k) __attribute__((always_inline)) { return rows[k]; };
        blur_row<F>(row_of_tap, taps_down(y), kDownShift, sweep_.settings, result, sweep_.width());
    }

    TapRow taps_across(int y) { return {bits_.row(y), total_across_.row(y), group_across_.row(y)}; }
    TapRow taps_down(int y) { return {bits_.row(y), total_down_.row(y), group_down_.row(y)}; }

    const BlurSweep& sweep_;
    RowRing<float> normal_x_, normal_y_, normal_z_, view_depth_;  // of the row whose pairs are decided
    RowRing<std::int32_t> pairs_, bits_;
    RowRing<float> total_across_, total_down_;
    RowRing<GroupTaps> group_across_, group_down_;
    RowRing<float> source_;               // the row that the next pass across reads
    std::vector<RowRing<float>> across_;  // what the pass across of each iteration wrote
};

}  // namespace crevice
