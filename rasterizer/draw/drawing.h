// A drawing of set-up triangles: what is drawn, how depths are compared, and where the results go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rasterizer/draw/lane_edge.h"
#include "rasterizer/draw/visibility.h"

namespace crevice {

// What is drawn, and where to.
struct Drawing {
    const ScreenGeometry& geometry;
    DepthFunction test;
    DepthFormat format;
    const Image<std::int32_t>& tested;       // depth codes
    Image<std::int32_t>* depth;              // the same, to be written; null: they stay
    std::optional<std::int32_t> clear_code;  // of tiles before their first triangle; none: depths are kept
    Image<std::int32_t>* triangle;           // to be written; null: not asked for
    const Holes& holes;
    // Numbers of what is left out as a whole; null: not asked for.
    std::vector<std::int32_t>* hidden = nullptr;
};

// The pixels that a drawing reads and writes, its pictures being of one size. Copied out of them: what is read through a
// reference is read again after every store.
struct DrawnPixels {
    const std::int32_t* tested;
    std::int32_t *depth, *triangle;  // may be null, as in Drawing
    std::ptrdiff_t stride;

    explicit DrawnPixels(const Drawing& drawing)
        : tested(drawing.tested.row(0)),
          depth(drawing.depth == nullptr ? nullptr : drawing.depth->row(0)),
          triangle(drawing.triangle == nullptr ? nullptr : drawing.triangle->row(0)),
          stride(drawing.tested.stride) {}
    CREVICE_INLINE std::ptrdiff_t at(int x, int y) const { return y * stride + x; }
};

// Where a group of pixels lies in them (kGroupColumns).
template <class F>
struct GroupPlace {
    std::ptrdiff_t at;
    std::ptrdiff_t below;  // to its second row; 0 where that is beyond the tile, whose rows end at end_y

    CREVICE_INLINE GroupPlace(const DrawnPixels& pixels, int x, int y, int end_y)
        : at(pixels.at(x, y)), below(y + 1 < end_y ? pixels.stride : 0) {}

    CREVICE_INLINE Mask<F> inside() const {
        return lane_index<F>() < Int<F>(below == 0 ? kGroupColumns<F> : kLanes<F>);
    }
    CREVICE_INLINE Int<F> load(const std::int32_t* plane) const {
        if constexpr (kGroupRows<F> == 1) {
            return crevice::load<F>(plane + at);
        } else {
            using Row = Wide<kGroupColumns<F>>;
            return Int<F>(joined(crevice::load<Row>(plane + at).v, crevice::load<Row>(plane + at + below).v));
        }
    }
    // The first row last: where there is no second one, it stands.
    CREVICE_INLINE void store(std::int32_t* plane, Int<F> values) const {
        if constexpr (kGroupRows<F> == 1) {
            crevice::store(plane + at, values);
        } else {
            using Row = WideInt<kGroupColumns<F>>;
            crevice::store(plane + at + below, Row(high_half(values.v)));
            crevice::store(plane + at, Row(low_half(values.v)));
        }
    }
};

}  // namespace crevice
