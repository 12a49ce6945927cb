// An AO map read at picture size, filtered linearly, edges clamped: 1 everywhere when the map is empty.
#pragma once

#include "rasterizer/base/run.h"
#include "rasterizer/lanes/wide.h"
#include "ssao/inputs/linear_taps.h"

namespace crevice {

// Where the pixels of a picture fall in its AO map.
struct AoTaps {
    const Image<float>& ao;
    LinearTaps columns, rows;

    AoTaps(const Image<float>& map, Size picture)
        : ao(map), columns(picture.width, map.size.width), rows(picture.height, map.size.height) {}
};

// The AO of a strip of columns, read row after row. Each row of the map is brought to the strip's width once, and
// serves all picture rows between itself and its neighbours.
template <class F>
class WidenedAo {
 public:
    static constexpr int kWidest_px = kLargestTile_px;

    // x0 is a multiple of kRowAlignment; the strip ends at x1 <= x0 + kWidest_px.
    WidenedAo(const AoTaps& taps, int x0, int x1) : taps_(taps), x0_(x0), x1_(x1) {}

    // Before the pixels of row y.
    CREVICE_INLINE void go_to_row(int y) {
        if (taps_.ao.empty()) return;
        const auto row = static_cast<std::size_t>(y);
        upper_ = widened(taps_.rows.first[row]);
        lower_ = widened(taps_.rows.second[row]);
        weight_of_lower_ = taps_.rows.weight_of_second[row];
    }

    // Accessibility at the pixels from x on.
    CREVICE_INLINE F at(int x) const {
        if (taps_.ao.empty()) return F(1);
        const F upper = load<F>(upper_ + (x - x0_)), lower = load<F>(lower_ + (x - x0_));
        return mix(upper, lower, F(weight_of_lower_));
    }

 private:
    // Neighbouring rows take turns in the two places.
    CREVICE_INLINE const float* widened(int map_row) {
        const int place = map_row & 1;
        float* const out = widened_[place];
        if (held_row_[place] == map_row) return out;
        held_row_[place] = map_row;
        const float* const in = taps_.ao.row(map_row);
        const LinearTaps& columns = taps_.columns;
        for (int x = x0_; x < x1_; x += kLanes<F>) {
            const Int<F> left = load<F>(columns.first.data() + x), right = load<F>(columns.second.data() + x);
            const F weight = load<F>(columns.weight_of_second.data() + x);
            store(out + (x - x0_), mix(F(gather(in, left)), F(gather(in, right)), weight));
        }
        return out;
    }

    const AoTaps& taps_;
    int x0_, x1_;
    const float *upper_ = nullptr, *lower_ = nullptr;
    float weight_of_lower_ = 0;
    int held_row_[2] = {-1, -1};
    float widened_[2][kWidest_px];
};

// The whole map.
Image<float> ao_at_picture_size(const Image<float>& ao, Size picture, const Run& run = {});

}  // namespace crevice
