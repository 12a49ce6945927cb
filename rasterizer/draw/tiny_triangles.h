// Triangles of a few pixels, as many at a time as there are lanes: one lane a triangle. Drawn one by one, most of the
// lanes of a group of pixels lie beside them, and most of the time goes to setting up their edges.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "rasterizer/draw/lane_edge.h"

namespace crevice {

// Waits for as many triangles as there are lanes, then finds all their fragments. Their order stays that of submission.
template <class F>
class TinyTriangles {
 public:
    static constexpr int kSide_px = 4;

    // Whether it is one, and lies in the tile as a whole.
    static bool has(const ScreenTriangle& t, PixelRect tile) {
        const PixelRect& b = t.bounds;
        return b.x1 - b.x0 <= kSide_px && b.y1 - b.y0 <= kSide_px && b.x0 >= tile.x0 && b.y0 >= tile.y0 &&
               b.x1 <= tile.x1 && b.y1 <= tile.y1;
    }

    // Must not be called when full().
    void add(const ScreenTriangle& t, std::int32_t number) {
        const auto lane = static_cast<std::size_t>(count_++);
        for (std::size_t i = 0; i < 3; ++i) {
            x_[i][lane] = t.x[i];
            y_[i][lane] = t.y[i];
        }
        z0_[lane] = t.z0;
        z_per_e1_[lane] = t.z_per_e1;
        z_per_e2_[lane] = t.z_per_e2;
        left_[lane] = t.bounds.x0;
        top_[lane] = t.bounds.y0;
        number_[lane] = number;
        depth_bias_[lane] = t.depth_bias;
        columns_ = std::max(columns_, t.bounds.x1 - t.bounds.x0);
        rows_ = std::max(rows_, t.bounds.y1 - t.bounds.y0);
    }
    bool full() const { return count_ == kLanes<F>; }

    // Calls fragment(number, x, y, code) for every pixel that one of the triangles covers, triangle by triangle, and
    // forgets them. Depths get their codes one by one: fewer pixels are covered than looked at.
    template <class Fragment>
    CREVICE_INLINE void take(DepthFormat format, const Fragment& fragment) {
        if (count_ == 0) return;
        alignas(64) float z_ndc[kSide_px * kSide_px][kLanes<F>];
        alignas(64) std::int32_t covered[kLanes<F>];
        cover(z_ndc, covered);
        for (int lane = 0; lane < count_; ++lane) {
            const auto at = static_cast<std::size_t>(lane);
            for (auto left = static_cast<std::uint32_t>(covered[lane]); left != 0; left &= left - 1) {
                const int pixel = std::countr_zero(left);
                fragment(number_[at], left_[at] + pixel % kSide_px, top_[at] + pixel / kSide_px,
                         depth_code(format, z_ndc[pixel][lane], depth_bias_[at]));
            }
        }
        count_ = columns_ = rows_ = 0;
    }

 private:
    using I = Int<F>;
    template <class T>
    using Lane = std::array<T, kLanes<F>>;

    // An edge of each triangle, less its threshold, at the centre of the first pixel.
    struct Edges {
        I here, per_column, per_row, threshold;
    };
    CREVICE_INLINE Edges edges(std::size_t from, std::size_t to, I centre_x, I centre_y) const {
        const I x = load<F>(x_[from].data()), y = load<F>(y_[from].data());
        const I dx = load<F>(x_[to].data()) - x, dy = load<F>(y_[to].data()) - y, zero(0), one(1);
        const I threshold = select(((dy == zero) & (dx > zero)) | (dy < zero), zero, one);
        const I steps(kSubpixelSteps);
        return {dx * (centre_y - y) - dy * (centre_x - x) - threshold, (zero - dy) * steps, dx * steps,
                threshold};
    }

    // Of each triangle: bit y * kSide_px + x where it covers that pixel of its bounds, and the depths there.
    CREVICE_INLINE void cover(float (&z_ndc)[kSide_px * kSide_px][kLanes<F>],
                              std::int32_t (&covered)[kLanes<F>]) const {
        const I half(kSubpixelSteps / 2), steps(kSubpixelSteps);
        const I centre_x = load<F>(left_.data()) * steps + half,
                centre_y = load<F>(top_.data()) * steps + half;
        Edges a = edges(1, 2, centre_x, centre_y), b = edges(2, 0, centre_x, centre_y),
              c = edges(0, 1, centre_x, centre_y);
        const struct {
            F z0, z_per_e1, z_per_e2;
        } plane = {load<F>(z0_.data()), load<F>(z_per_e1_.data()), load<F>(z_per_e2_.data())};
        I bits(0);
        for (int y = 0; y < rows_; ++y) {
            I e0 = a.here, e1 = b.here, e2 = c.here;
            for (int x = 0; x < columns_; ++x) {
                const Mask<F> inside = none_negative<F>(e0, e1, e2);
                const int pixel = y * kSide_px + x;
                bits = bits | select(inside, I(1 << pixel), I(0));
                store(z_ndc[pixel],
                      z_ndc_at<F>(plane, F(to_float(e1 + b.threshold)), F(to_float(e2 + c.threshold))));
                e0 = e0 + a.per_column;
                e1 = e1 + b.per_column;
                e2 = e2 + c.per_column;
            }
            a.here = a.here + a.per_row;
            b.here = b.here + b.per_row;
            c.here = c.here + c.per_row;
        }
        store(covered, bits);
    }

    std::array<Lane<std::int32_t>, 3> x_{}, y_{};
    Lane<float> z0_{}, z_per_e1_{}, z_per_e2_{};
    Lane<std::int32_t> left_{}, top_{}, number_{};
    Lane<double> depth_bias_{};
    int count_ = 0, columns_ = 0, rows_ = 0;  // of the largest
};

}  // namespace crevice
