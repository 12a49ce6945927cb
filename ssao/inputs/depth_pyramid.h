// The picture's view depths at full, half, a quarter ... of its size, so that taps far from each other on the
// screen are near each other in memory.
// Source: McGuire, Mara, Luebke 2012, "Scalable ambient obscurance" (HPG): each cell of a level is one of the
//         four below it, which one alternates from cell to cell; no depth is a mean of two surfaces.
// In:     AoInputs::depth_map of view depths
// Out:    at each level real points of the picture: a fetch tells the depth and the pixel that it was picked
//         from
// Differs from the source: all levels lie in one array, so that each lane can read from a level of its own.
#pragma once

#include <array>

#include "rasterizer/base/cache_line_array.h"
#include "rasterizer/base/run.h"
#include "ssao/inputs/pixel_fetch.h"

namespace crevice {

// The paper's levels 0 to 5.
inline constexpr int kPyramidLevels = 6;

class DepthPyramid {
 public:
    // Levels 0 to `top`, or as many as the picture's shorter side has halves.
    DepthPyramid(const AoInputs& inputs, int top, const Run& run);

    int top() const { return top_; }
    Size size(int level) const { return {size_.width >> level, size_.height >> level}; }
    // Cell (x, y) of a level.
    float at(int level, int x, int y) const {
        return depths_[static_cast<std::size_t>(first_[index(level)] + y * stride_[index(level)] + x)];
    }

    template <class F>
    struct Fetched {
        F z;             // view depth
        Screen2<F> at;   // the centre of the picked pixel, pixels of the picture
        Mask<F> inside;  // false: the position is beyond the picture, where the others mean nothing
    };

    // What a level in [0, top()] holds at a screen position.
    template <class F>
    CREVICE_INLINE Fetched<F> fetch(Screen2<F> position, Int<F> level) const {
        const F width = F(static_cast<float>(size_.width)), height = F(static_cast<float>(size_.height));
        const Mask<F> inside =
            (position.x >= F(0)) & (position.x < width) & (position.y >= F(0)) & (position.y < height);
        // 2^level and its inverse, exactly.
        const F cell_px = float_from_bits((level + Int<F>(127)) << 23),
                per_px = float_from_bits((Int<F>(127) - level) << 23);
        const Int<F> x = cell_of(position.x, width, per_px), y = cell_of(position.y, height, per_px);
        const Int<F> first(gather(first_.data(), level)), stride(gather(stride_.data(), level));
        const F own(gather(kOwnBits.data(), level)), other(gather(kOtherBits.data(), level));
        const F odd_x = F(to_float(x & Int<F>(1))), odd_y = F(to_float(y & Int<F>(1)));
        const F picked_x = F(to_float(x)) * cell_px + other * (F(1) - odd_y) + own * odd_x,
                picked_y = F(to_float(y)) * cell_px + other * (F(1) - odd_x) + own * odd_y;
        F depth = F(gather(depths_.data(), first + y * stride + x));
        if constexpr (std::is_same_v<F, double>) {
            if (!in_double_.empty()) depth = in_double_.at(to_int(picked_x), to_int(picked_y));
        }
        return {depth, {picked_x + F(0.5f), picked_y + F(0.5f)}, inside};
    }

 private:
    static std::size_t index(int level) { return static_cast<std::size_t>(level); }

    // A picture of odd width has a last column with no cell of its own: it belongs to the one before.
    template <class F>
    CREVICE_INLINE static Int<F> cell_of(F position, F count, F per_px) {
        const F pixel = F(to_float(to_int(min_of(max_of(position, F(0)), count - F(1)))));
        return min_of(to_int(pixel * per_px), to_int(count * per_px) - Int<F>(1));
    }

    // Cell (x, y) was picked from (2x + odd(y + 1), 2y + odd(x + 1)) a level below, and that in the same way
    // from below it: the bits that x gains from level to level are in turn those of y + 1 and x.
    static constexpr std::array<float, kPyramidLevels> kOtherBits = {0, 1, 2, 5, 10, 21},
                                                       kOwnBits = {0, 0, 1, 2, 5, 10};

    Size size_;
    int top_ = 0;
    std::array<std::int32_t, kPyramidLevels> first_{}, stride_{};
    CacheLineArray<float> depths_;
    Image<double> in_double_;  // the picture's, where the inputs have it (AoInputs::in_double)
};

// As fetch_pixel() does it for the picture itself, of a level in [0, top()]: the pixel that the level picked near a
// screen position, and the surface there. Level 0 and what lies beyond the picture have the same bits as there.
template <class F>
CREVICE_INLINE FetchedPixel<F> fetch_pixel(const AoInputs& inputs, const DepthPyramid& pyramid,
                                           Screen2<F> position, Int<F> level) {
    const FetchedPixel<F> fine = fetch_pixel(inputs, position);
    if (!any(level > Int<F>(0))) return fine;
    const auto picked = pyramid.fetch(position, level);
    const Screen2<F> at = {select(picked.inside, picked.at.x, fine.at.x),
                           select(picked.inside, picked.at.y, fine.at.y)};
    const F width = F(static_cast<float>(inputs.picture.width)),
            height = F(static_cast<float>(inputs.picture.height));
    return {at, inputs.rays.p_view(at.x / width, at.y / height, select(picked.inside, picked.z, fine.r.z))};
}

}  // namespace crevice
