// A group of pixels that show one triangle: where in it they lie, and what follows from its three corners there.
#pragma once

#include <bit>

#include "rasterizer/draw/lane_edge.h"
#include "rasterizer/draw/view_ray.h"
#include "rasterizer/draw/visibility.h"

namespace crevice {

// Perspective-correct barycentric coordinates for ScreenTriangle::vertex[1] and [2].
template <class F>
struct Barycentric {
    F lambda1, lambda2;

    // An attribute of the three vertices here. A constant attribute comes out bit-constant.
    CREVICE_INLINE F interpolate(float a0, float a1, float a2) const {
        return F(a0) + lambda1 * (F(a1) - F(a0)) + lambda2 * (F(a2) - F(a0));
    }
    CREVICE_INLINE Vec3<F> interpolate(const glm::vec3& a0, const glm::vec3& a1, const glm::vec3& a2) const {
        return {interpolate(a0.x, a1.x, a2.x), interpolate(a0.y, a1.y, a2.y), interpolate(a0.z, a1.z, a2.z)};
    }
};

// Three values of a group of pixels, one for each edge or corner. Not an array: GCC keeps those in memory.
template <class F>
struct Three {
    F of_0, of_1, of_2;
};

template <class F>
struct TrianglePixels {
    const ScreenTriangle& triangle;
    const ClippedCorners* const clipped;  // null: the triangle is whole
    const Mask<F> shown;                  // which pixels show it; values elsewhere mean nothing
    const Three<F> e;                     // the edge functions at the pixels' centres
    const Three<F> b;                     // e / w, whose shares are the coordinates
    const F inverse_sum;                  // 1 / (b0 + b1 + b2)
    const Barycentric<F> here;

    // The pixels (x, y) ... (x + lanes - 1, y).
    CREVICE_INLINE TrianglePixels(NumberedTriangle of, Mask<F> shown_by_it, int x, int y)
        : triangle(*of.triangle),
          clipped(of.clipped),
          shown(shown_by_it),
          e(of.triangle->doubled_area < kFitsWord ? edges<Int<F>>(*of.triangle, x, y)
                                                  : edges<Double<F>>(*of.triangle, x, y)),
          b{e.of_0 * F(triangle.inverse_w[0]), e.of_1 * F(triangle.inverse_w[1]),
            e.of_2 * F(triangle.inverse_w[2])},
          inverse_sum(inverse(b)),
          here(shares(b, inverse_sum)) {}

    // Scene units.
    CREVICE_INLINE F view_depth(const ScreenGeometry& geometry) const {
        if (geometry.rays.perspective) return F(triangle.doubled_area) * inverse_sum;
        return (z_ndc_at<F>(triangle, e.of_1, e.of_2) - F(geometry.depth_a)) / F(geometry.depth_b);
    }

    // The coordinates `columns` and `rows` of pixels away, inside the triangle or not.
    CREVICE_INLINE Barycentric<F> away(int columns, int rows) const {
        const auto moved = [&](F at, int i) __attribute__((always_inline)) {
            const Edge edge = triangle_edge(triangle, i);
            return at + F(static_cast<float>(edge.per_column * columns + edge.per_row * rows) *
                          triangle.inverse_w[static_cast<std::size_t>(i)]);
        };
        const Three<F> there{moved(b.of_0, 0), moved(b.of_1, 1), moved(b.of_2, 2)};
        return shares(there, inverse(there));
    }

    // The interpolated vertex normal, view space, not normalised; of a back face the other way. The winding alone
    // says which side is seen: near the rim of a smooth mesh the interpolated normal leans over to the other.
    CREVICE_INLINE Vec3<F> interpolated_normal(const ScreenGeometry& geometry) const {
        const VertexArray<glm::vec3>& n_view = geometry.vertices.n_view;
        const Vec3<F> n = here.interpolate(n_view[triangle.vertex[0]], n_view[triangle.vertex[1]],
                                           n_view[triangle.vertex[2]]);
        const F zero(0);
        if (!triangle.shows_back) return n;
        return {zero - n.x, zero - n.y, zero - n.z};
    }

 private:
    // Inside a triangle no edge function is larger than its doubled area.
    static constexpr float kFitsWord = 0x1p31f;

    // E is Int<F> where the edge functions fit it at the pixels shown, or Double<F>, which holds those of any triangle.
    template <class E>
    CREVICE_INLINE static Three<F> edges(const ScreenTriangle& t, int x, int y) {
        constexpr std::int32_t half = kSubpixelSteps / 2;
        const Int<F> centre_x = lane_index<F>() * Int<F>(kSubpixelSteps) + Int<F>(x * kSubpixelSteps + half);
        const Int<F> centre_y(y * kSubpixelSteps + half);
        const auto from_corner = [](Int<F> centre, std::int32_t corner) __attribute__((always_inline)) {
            if constexpr (std::is_same_v<E, Int<F>>) {
                return centre - Int<F>(corner);
            } else {
                return to_double(centre - Int<F>(corner));
            }
        };
        const E x_0 = from_corner(centre_x, t.x[0]), x_1 = from_corner(centre_x, t.x[1]),
                x_2 = from_corner(centre_x, t.x[2]);
        const E y_0 = from_corner(centre_y, t.y[0]), y_1 = from_corner(centre_y, t.y[1]),
                y_2 = from_corner(centre_y, t.y[2]);
        const auto edge = [](E x_from, E y_to, E y_from, E x_to) __attribute__((always_inline)) {
            if constexpr (std::is_same_v<E, Int<F>>) {
                return F(to_float(wrapped_difference(x_from, y_to, y_from, x_to)));
            } else {
                const E zero(0);  // added, it leaves no -0
                return F(to_float(x_from * y_to - y_from * x_to + zero));
            }
        };
        return {edge(x_1, y_2, y_1, x_2), edge(x_2, y_0, y_2, x_0), edge(x_0, y_1, y_0, x_1)};
    }
    // Pixels outside the triangle may meet a sum of zero.
    CREVICE_INLINE F inverse(const Three<F>& of) const {
        return F(1) / select(shown, of.of_0 + of.of_1 + of.of_2, F(1));
    }
    // Of a piece that clipping left, in terms of the whole triangle.
    CREVICE_INLINE Barycentric<F> shares(const Three<F>& of, F inverse_of_sum) const {
        const Barycentric<F> in_piece{of.of_1 * inverse_of_sum, of.of_2 * inverse_of_sum};
        if (clipped == nullptr) return in_piece;
        const auto &l1 = clipped->lambda1, &l2 = clipped->lambda2;
        return {in_piece.interpolate(l1[0], l1[1], l1[2]), in_piece.interpolate(l2[0], l2[1], l2[2])};
    }
};

// The triangles of a group of pixels, one after the other:
//   for (TriangleWalk<F> walk(numbers); walk.next();) ... TrianglePixels<F>(geometry.triangle(walk.number), walk.shown, x, y)
template <class F>
struct TriangleWalk {
    std::int32_t number = kNoTriangle;
    Mask<F> shown;  // which pixels show it

    // `numbers` says which triangle each pixel shows, or kNoTriangle.
    CREVICE_INLINE explicit TriangleWalk(Int<F> numbers)
        : shown(numbers < numbers), numbers_(numbers), left_(lane_bits(numbers != Int<F>(kNoTriangle))) {
        store(number_of_, numbers);
    }
    CREVICE_INLINE bool next() {
        if (left_ == 0) return false;
        number = number_of_[std::countr_zero(left_)];
        shown = numbers_ == Int<F>(number);
        left_ &= ~lane_bits(shown);
        return true;
    }

 private:
    Int<F> numbers_;
    unsigned left_;
    alignas(64) std::int32_t number_of_[kLanes<F>];
};

}  // namespace crevice
