// The edge functions of a triangle over groups of pixels, exact: 32-bit integers for small triangles, doubles
// (exact below 2^53) for the others. Both round the same integer to float, so the choice changes no bit.
#pragma once

#include <type_traits>

#include "rasterizer/draw/triangle_setup.h"

namespace crevice {

// The pixels of a group, lane by lane: a row, or from sixteen lanes on rows of eight below each other. A row of sixteen
// would leave most lanes without a pixel of the triangle.
template <class F>
inline constexpr int kGroupColumns = kLanes<F> < 8 ? kLanes<F> : 8;
template <class F>
inline constexpr int kGroupRows = kLanes<F> / kGroupColumns<F>;

// E is Int<F> or Double<F>. Values are kept less by the edge's threshold, so that covered means not negative.
template <class F, class E>
struct LaneEdge {
    using Scalar = std::conditional_t<std::is_same_v<E, Int<F>>, std::int32_t, double>;
    Edge edge;
    E lane_offsets, per_row, threshold;  // per_row: from a group to the one below

    CREVICE_INLINE explicit LaneEdge(const Edge& of_triangle)
        : edge(of_triangle),
          lane_offsets(offsets(edge)),
          per_row(static_cast<Scalar>(kGroupRows<F> * edge.per_row)),
          threshold(static_cast<Scalar>(edge.threshold)) {}

    CREVICE_INLINE std::int64_t at(int x, int y) const {
        return edge.at_origin + edge.per_column * x + edge.per_row * y - edge.threshold;
    }

    // Its values at groups of pixels, one below the other.
    struct Column {
        E lanes, per_row;
        CREVICE_INLINE void next() { lanes = lanes + per_row; }
    };
    // Less the threshold, and with it.
    CREVICE_INLINE Column column(int x, int y) const { return column_from(at(x, y)); }
    CREVICE_INLINE Column whole_column(int x, int y) const { return column_from(at(x, y) + edge.threshold); }

 private:
    CREVICE_INLINE Column column_from(std::int64_t first) const {
        return {E(static_cast<Scalar>(first)) + lane_offsets, per_row};
    }
    CREVICE_INLINE static E offsets(const Edge& edge) {
        const E per_column(static_cast<Scalar>(edge.per_column));
        if constexpr (kGroupRows<F> == 1) {
            return as_edge(lane_index<F>()) * per_column;
        } else {
            const Int<F> column = lane_index<F>() & Int<F>(kGroupColumns<F> - 1);
            const Int<F> row = select(lane_index<F>() == column, Int<F>(0), Int<F>(1));
            return as_edge(column) * per_column + as_edge(row) * E(static_cast<Scalar>(edge.per_row));
        }
    }
    CREVICE_INLINE static E as_edge(Int<F> a) {
        if constexpr (std::is_same_v<E, Int<F>>) {
            return a;
        } else {
            return to_double(a);
        }
    }
};

// Whether all three, whole numbers and none of them -0, are >= 0: one look at the joined sign bits is enough.
template <class F, class E>
CREVICE_INLINE Mask<F> none_negative(E a, E b, E c) {
    if constexpr (std::is_same_v<E, Int<F>>) {
        return (a | b | c) >= E(0);
    } else {
        return (upper_bits(a) | upper_bits(b) | upper_bits(c)) >= Int<F>(0);
    }
}

}  // namespace crevice
