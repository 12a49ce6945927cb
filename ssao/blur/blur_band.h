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

#include "ssao/blur/blur_pairs.h"
#include "ssao/blur/row_ring.h"

namespace crevice {

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

static_assert(kBlurRadius <= kRowAlignment);  // what a RowRing has beside a row

// The rows that a band is working on, and the steps of the sweep.
class BlurBand {
 public:
    explicit BlurBand(const BlurSweep& sweep)
        : sweep_(sweep),
          width_(sweep.width()),
          pairs_(width_, kBlurRadius + 1, 0),
          bits_(width_, sweep.reach() + 1, 0),
          total_across_(width_, sweep.reach() + 1, 1.0f),
          total_down_(width_, sweep.reach() + 1, 1.0f),
          group_across_(width_ / kSmallestBlurGroup, sweep.reach() + 1, GroupTaps::none),
          group_down_(width_ / kSmallestBlurGroup, sweep.reach() + 1, GroupTaps::none),
          source_(width_, 1, 0.0f),
          across_(static_cast<std::size_t>(sweep.iterations), RowRing<float>(width_, kBlurTaps, 0.0f)) {}

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
                    expect_next_row(*plane, 0, width_, step + kBlurRadius);
                decide_pairs<F>(step);
                decide_taps<F>(step);
                std::copy_n(sweep_.ao.row(step), width_, source_.row(0));
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
        const BlurPairs pairs(sweep_.inputs, sweep_.rays, sweep_.settings, y);
        const bool needs_surface = sweep_.settings.edges != BlurEdges::none && sweep_.skips_background;
        std::int32_t* const bits = pairs_.row(y);
        for (int tile = 0; tile < width_; tile += kBlurTile) {
            // A tile's pairs are also read to its right and below.
            const bool unread = sweep_.is_open(tile, y) && sweep_.is_open(tile + kBlurTile, y) &&
                                sweep_.is_open(tile, y + kBlurRadius);
            for (int x = tile; x < std::min(tile + kBlurTile, width_); x += kLanes<F>) {
                const bool none = unread || (needs_surface && !pairs.any_surface<F>(x));
                store(bits + x, none ? Int<F>(0) : pairs.bits<F>(x));
            }
        }
    }

    // From the pair bits of row y and of the five above it.
    template <class F>
    CREVICE_INLINE void decide_taps(int y) {
        PairRows pairs;
        for (int j = 0; j <= kBlurRadius; ++j) pairs[static_cast<std::size_t>(j)] = pairs_.row(y - j);
        const TapRow across = taps_across(y), down = taps_down(y);
        std::int32_t* const bits = bits_.row(y);
        const BlurWeights weights = sweep_.settings.weights;
        const F total_of_all = total_weight<F>(Int<F>(all_taps(kAcrossShift)), kAcrossShift, weights);
        const bool may_keep = sweep_.skips_background;
        for (int tile = 0; tile < width_; tile += kBlurTile) {
            const bool open = sweep_.is_open(tile, y);
            for (int x = tile; x < std::min(tile + kBlurTile, width_); x += kBlurGroup<F>) {
                if (open) {
                    across.group[x / kBlurGroup<F>] = down.group[x / kBlurGroup<F>] = GroupTaps::none;
                } else {
                    decide_bits<F>(pairs, bits, x);
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
        blur_row<F>(row_of_tap, taps_across(y), kAcrossShift, sweep_.settings, across.row(y), width_);
    }

    template <class F>
    CREVICE_INLINE void blur_down(RowRing<float>& across, int y, float* result) {
        // Of rows outside the map no tap counts, whatever stands there.
        const std::array<const float*, kBlurTaps> rows = across.template rows<kBlurTaps>(y - kBlurRadius);
        const auto row_of_tap = [&](auto k) __attribute__((always_inline)) { return rows[k]; };
        blur_row<F>(row_of_tap, taps_down(y), kDownShift, sweep_.settings, result, width_);
    }

    TapRow taps_across(int y) { return {bits_.row(y), total_across_.row(y), group_across_.row(y)}; }
    TapRow taps_down(int y) { return {bits_.row(y), total_down_.row(y), group_down_.row(y)}; }

    const BlurSweep& sweep_;
    const int width_;
    RowRing<std::int32_t> pairs_, bits_;
    RowRing<float> total_across_, total_down_;
    RowRing<GroupTaps> group_across_, group_down_;
    RowRing<float> source_;               // the row that the next pass across reads
    std::vector<RowRing<float>> across_;  // what the pass across of each iteration wrote
};

}  // namespace crevice
