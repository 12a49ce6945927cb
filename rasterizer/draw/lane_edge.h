// The edge functions of a triangle over groups of pixels, exact: 32-bit integers for small triangles, doubles
// (exact below 2^53) for the others. Both round the same integer to float, so the choice changes no bit.
#pragma once

#include <type_traits>

#include "rasterizer/draw/triangle_setup.h"

namespace crevice {

// E is Int<F> or Double<F>. Values are kept less by the edge's threshold, so that covered means not negative.
template <class F, class E>
struct LaneEdge {
    using Scalar = std::conditional_t<std::is_same_v<E, Int<F>>, std::int32_t, double>;
    Edge edge;
    E lane_offsets, per_row, threshold;

    CREVICE_INLINE explicit LaneEdge(const Edge& of_triangle)
        : edge(of_triangle),
          lane_offsets(lane() * E(static_cast<Scalar>(edge.per_column))),
          per_row(static_cast<Scalar>(edge.per_row)),
          threshold(static_cast<Scalar>(edge.threshold)) {}

    CREVICE_INLINE std::int64_t at(int x, int y) const {
        return edge.at_origin + edge.per_column * x + edge.per_row * y - edge.threshold;
    }

    // Its values at groups of pixels, one below the other. Doubles are carried from row to row as that of the first lane:
    // a vector of them is wider than the register, and GCC 12 carries it through memory, which took twice as long.
    class Column {
     public:
        CREVICE_INLINE Column(const LaneEdge& of, std::int64_t first) : of_(of), row_(start(of, first)) {}
        CREVICE_INLINE E lanes() const {
            if constexpr (kInLanes) {
                return row_;
            } else {
                return E(row_) + of_.lane_offsets;
            }
        }
        CREVICE_INLINE void next() {
            if constexpr (kInLanes) {
                row_ = row_ + of_.per_row;
            } else {
                row_ += static_cast<Scalar>(of_.edge.per_row);
            }
        }

     private:
        static constexpr bool kInLanes = std::is_same_v<E, Int<F>>;
        CREVICE_INLINE static auto start(const LaneEdge& of, std::int64_t first) {
            if constexpr (kInLanes) {
                return E(static_cast<Scalar>(first)) + of.lane_offsets;
            } else {
                return static_cast<Scalar>(first);
            }
        }
        const LaneEdge& of_;
        std::conditional_t<kInLanes, E, Scalar> row_;
    };
    // Less the threshold, and with it.
    CREVICE_INLINE Column column(int x, int y) const { return Column(*this, at(x, y)); }
    CREVICE_INLINE Column whole_column(int x, int y) const {
        return Column(*this, at(x, y) + edge.threshold);
    }

 private:
    CREVICE_INLINE static E lane() {
        if constexpr (std::is_same_v<E, Int<F>>) {
            return lane_index<F>();
        } else {
            return to_double(lane_index<F>());
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
