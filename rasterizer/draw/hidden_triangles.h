// Hierarchical depth: the range of the depths stored in each square of a tile, so that a triangle behind all of
// them is left out as a whole.
//
// While a tile is drawn its depths move one way only (LESS: nearer), so a range read earlier still bounds them: it
// is read again after 64 triangles, then after twice as many each time, which costs next to nothing in a tile
// where nothing is hidden.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "rasterizer/draw/depth_buffer.h"
#include "rasterizer/draw/triangle_setup.h"

namespace crevice {

class HiddenTriangles {
 public:
    static constexpr int kSquare_px = 16;
    static constexpr int kSquares = kLargestTile_px / kSquare_px;  // along the largest tile

    explicit HiddenTriangles(PixelRect tile) : tile_(tile) {}

    // Reads the ranges when enough triangles have been drawn since.
    template <class F>
    CREVICE_INLINE void count_triangle(const Image<std::int32_t>& codes) {
        if (++drawn_ < next_reading_) return;
        next_reading_ *= 2;
        for (int y = 0; y * kSquare_px < tile_.y1 - tile_.y0; ++y) {
            for (int x = 0; x * kSquare_px < tile_.x1 - tile_.x0; ++x) {
                squares_[static_cast<std::size_t>(y * kSquares + x)] =
                    range<F>(codes, tile_.x0 + x * kSquare_px, tile_.y0 + y * kSquare_px);
            }
        }
        known_ = true;
    }

    // What becomes of a triangle as a whole: is it hidden, and then, might one of its depths equal a stored one?
    struct Verdict {
        bool hidden, tied;
    };

    // `rect` is the part of the tile that the triangle's bounding box reaches.
    Verdict verdict(DepthFunction test, DepthFormat format, const ScreenTriangle& t, PixelRect rect) const {
        if (!known_) return {false, false};
        const std::int32_t low = depth_code(format, t.z_low, t.depth_bias),
                           high = depth_code(format, t.z_high, t.depth_bias);
        bool tied = false;
        for (int y = (rect.y0 - tile_.y0) / kSquare_px; y <= (rect.y1 - 1 - tile_.y0) / kSquare_px; ++y) {
            for (int x = (rect.x0 - tile_.x0) / kSquare_px; x <= (rect.x1 - 1 - tile_.x0) / kSquare_px; ++x) {
                const Range& stored = squares_[static_cast<std::size_t>(y * kSquares + x)];
                if (may_pass(test, low, high, stored)) return {false, false};
                tied = tied || (low <= stored.high && high >= stored.low);
            }
        }
        return {true, tied};
    }

 private:
    struct Range {
        std::int32_t low, high;  // codes
    };
    static constexpr int kFirstReading = 64;  // triangles

    static bool may_pass(DepthFunction test, std::int32_t low, std::int32_t high, const Range& stored) {
        switch (test) {
            case DepthFunction::less: return low < stored.high;
            case DepthFunction::less_equal: return low <= stored.high;
            case DepthFunction::greater: return high > stored.low;
            case DepthFunction::greater_equal: return high >= stored.low;
            case DepthFunction::equal: return low <= stored.high && high >= stored.low;
            case DepthFunction::never: return false;
            case DepthFunction::not_equal:
            case DepthFunction::always: return true;
        }
        return true;
    }

    // Of the tile's own pixels: what pads a row at the picture's right edge holds anything.
    template <class F>
    CREVICE_INLINE Range range(const Image<std::int32_t>& codes, int x0, int y0) const {
        const int x1 = std::min(x0 + kSquare_px, tile_.x1), y1 = std::min(y0 + kSquare_px, tile_.y1);
        Int<F> low(std::numeric_limits<std::int32_t>::max()),
            high(std::numeric_limits<std::int32_t>::lowest());
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; x += kLanes<F>) {
                const Int<F> code = load<F>(codes.row(y) + x);
                const Mask<F> inside = lane_index<F>() < Int<F>(x1 - x);
                low = min_of(low, select(inside, code, low));
                high = max_of(high, select(inside, code, high));
            }
        }
        return {-largest_of(Int<F>(0) - low), largest_of(high)};
    }

    PixelRect tile_;
    int drawn_ = 0, next_reading_ = kFirstReading;
    bool known_ = false;
    std::array<Range, kSquares * kSquares> squares_{};
};

}  // namespace crevice
