// The triangles that a group of pixels shows, one a lane: where in them the pixels lie, and what follows from
// the three corners there. The text is the same whether the lanes show one triangle or each its own; with one,
// its numbers are read once.
#pragma once

#include "rasterizer/draw/visibility.h"
#include "rasterizer/lanes/vec3.h"

namespace crevice {

// Perspective-correct barycentric coordinates for ScreenTriangle::vertex[1] and [2].
template <class F>
struct Barycentric {
    F lambda1, lambda2;

    // An attribute of the three vertices here. A constant attribute comes out bit-constant.
    CREVICE_INLINE F interpolate(F a0, F a1, F a2) const {
        return a0 + lambda1 * (a1 - a0) + lambda2 * (a2 - a0);
    }
    CREVICE_INLINE Vec3<F> interpolate(Vec3<F> a0, Vec3<F> a1, Vec3<F> a2) const {
        return {interpolate(a0.x, a1.x, a2.x), interpolate(a0.y, a1.y, a2.y), interpolate(a0.z, a1.z, a2.z)};
    }
};

// kAlike: all lanes that show a triangle show the same one.
template <class F, bool kAlike>
class TriangleLanes {
 public:
    const Mask<F> shown;  // which pixels show a triangle; values elsewhere mean nothing

    // The pixels (x, y) ... (x + lanes - 1, y) and the numbers of their triangles, of which one at least is one.
    CREVICE_INLINE TriangleLanes(const ScreenGeometry& geometry, Int<F> numbers, int x, int y)
        : shown(numbers >= Int<F>(0)) {
        const std::int32_t any_shown = largest_of(numbers);
        std::int32_t number[kLanes<F>];
        store(number, select(shown, numbers, Int<F>(any_shown)));
        for (int i = 0; i < kDistinct; ++i) triangle_[i] = geometry.triangle(number[i]);
        locate(x, y);
    }
    // Pixels of one triangle.
    CREVICE_INLINE TriangleLanes(NumberedTriangle triangle, Mask<F> shown_by_it, int x, int y) requires kAlike
        : shown(shown_by_it),
          triangle_{triangle} {
        locate(x, y);
    }

    // of(triangle), a float, an integer or a yes/no, of each lane's triangle.
    template <class Of>
    CREVICE_INLINE auto each(const Of& of) const {
        using T = decltype(of(*triangle_[0].triangle));
        using Lane = std::conditional_t<std::is_same_v<T, float>, F, Int<F>>;
        using Scalar = std::conditional_t<std::is_same_v<T, float>, float, std::int32_t>;
        if constexpr (kAlike) {
            return Lane(static_cast<Scalar>(of(*triangle_[0].triangle)));
        } else {
            Scalar value[kLanes<F>];
            for (int i = 0; i < kLanes<F>; ++i) value[i] = static_cast<Scalar>(of(*triangle_[i].triangle));
            return load<F>(value);
        }
    }
    // of(triangle), a vec3, likewise.
    template <class Of>
    CREVICE_INLINE Vec3<F> each_vec3(const Of& of) const {
        float x[kLanes<F>], y[kLanes<F>], z[kLanes<F>];
        for (int i = 0; i < kDistinct; ++i) {
            const glm::vec3 value = of(*triangle_[i].triangle);
            x[i] = value.x;
            y[i] = value.y;
            z[i] = value.z;
        }
        if constexpr (kAlike) {
            return {F(x[0]), F(y[0]), F(z[0])};
        } else {
            return {load<F>(x), load<F>(y), load<F>(z)};
        }
    }

    CREVICE_INLINE const Barycentric<F>& here() const { return here_; }
    // Scene units.
    CREVICE_INLINE F view_depth(const ScreenGeometry& geometry) const {
        if (geometry.rays.perspective) return perspective_depth_;
        struct {
            F z0, z_per_e1, z_per_e2;
        } const plane{each([](const ScreenTriangle& t) { return t.z0; }),
                      each([](const ScreenTriangle& t) { return t.z_per_e1; }),
                      each([](const ScreenTriangle& t) { return t.z_per_e2; })};
        return (z_ndc_at<F>(plane, e_[1], e_[2]) - F(geometry.depth_a)) / F(geometry.depth_b);
    }

    // The coordinates `columns` and `rows` of pixels away, inside the triangle or not.
    CREVICE_INLINE Barycentric<F> away(int columns, int rows) const {
        F b[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const Double<F> step =
                (dx_[i] * Double<F>(rows) - dy_[i] * Double<F>(columns)) * Double<F>(kSubpixelSteps);
            b[i] = b_[i] + to_float(step) * inverse_w_[i];
        }
        return shares(b[1], b[2], inverse_sum(b[0], b[1], b[2]));
    }

    // The interpolated vertex normal, view space, not normalised. On a back face it is turned to the eye where
    // it points away; where it does not (the rim of a smooth closed mesh), it is the better normal as it stands.
    struct Normal {
        Vec3<F> n;
        Mask<F> turned;
    };
    CREVICE_INLINE Normal interpolated_normal(const std::vector<glm::vec3>& n_view, Vec3<F> view_ray) const {
        const Vec3<F> n =
            here_.interpolate(each_vec3([&](const ScreenTriangle& t) { return n_view[t.vertex[0]]; }),
                              each_vec3([&](const ScreenTriangle& t) { return n_view[t.vertex[1]]; }),
                              each_vec3([&](const ScreenTriangle& t) { return n_view[t.vertex[2]]; }));
        const F zero(0);
        const Mask<F> turned = (each([](const ScreenTriangle& t) { return t.back_facing; }) != Int<F>(0)) &
                               (dot(n, view_ray) > zero);
        return {select<F>(turned, {zero - n.x, zero - n.y, zero - n.z}, n), turned};
    }

 private:
    // E_i at the pixels' centres, exact whole numbers rounded once, and what follows from them.
    CREVICE_INLINE void locate(int x, int y) {
        Int<F> corner_x[3], corner_y[3];
        for (std::size_t i = 0; i < 3; ++i) {
            corner_x[i] = each([&](const ScreenTriangle& t) { return t.x[i]; });
            corner_y[i] = each([&](const ScreenTriangle& t) { return t.y[i]; });
            inverse_w_[i] = each([&](const ScreenTriangle& t) { return t.inverse_w[i]; });
        }
        constexpr std::int32_t half = kSubpixelSteps / 2;
        const Int<F> centre_x = ((lane_index<F>() + Int<F>(x)) << kSubpixelBits) + Int<F>(half),
                     centre_y(y * kSubpixelSteps + half);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = (i + 1) % 3, to = (i + 2) % 3;
            dx_[i] = to_double(corner_x[to] - corner_x[from]);
            dy_[i] = to_double(corner_y[to] - corner_y[from]);
            e_[i] = to_float(dx_[i] * to_double(centre_y - corner_y[from]) -
                             dy_[i] * to_double(centre_x - corner_x[from]));
            b_[i] = e_[i] * inverse_w_[i];
        }
        find_clipped();
        const F inverse = inverse_sum(b_[0], b_[1], b_[2]);
        here_ = shares(b_[1], b_[2], inverse);
        perspective_depth_ = each([](const ScreenTriangle& t) { return t.doubled_area; }) * inverse;
    }

    CREVICE_INLINE void find_clipped() {
        clipped_ = each([](const ScreenTriangle& t) { return t.clipped; }) >= Int<F>(0);
        any_clipped_ = any(clipped_);
        if (!any_clipped_) return;
        for (std::size_t k = 0; k < 3; ++k) {
            float lambda1[kLanes<F>], lambda2[kLanes<F>];
            for (int i = 0; i < kLanes<F>; ++i) {
                const ClippedCorners* const corners = triangle_[kAlike ? 0 : i].clipped;
                lambda1[i] = corners == nullptr ? 0 : corners->lambda1[k];
                lambda2[i] = corners == nullptr ? 0 : corners->lambda2[k];
            }
            lambda1_[k] = load<F>(lambda1);
            lambda2_[k] = load<F>(lambda2);
        }
    }

    // 1 / (b0 + b1 + b2); lanes outside their triangle may meet a zero.
    CREVICE_INLINE F inverse_sum(F b0, F b1, F b2) const { return F(1) / select(shown, b0 + b1 + b2, F(1)); }

    // Of a piece that clipping left, in terms of the whole triangle.
    CREVICE_INLINE Barycentric<F> shares(F b1, F b2, F inverse) const {
        const Barycentric<F> of_piece{b1 * inverse, b2 * inverse};
        if (!any_clipped_) return of_piece;
        return {
            select(clipped_, of_piece.interpolate(lambda1_[0], lambda1_[1], lambda1_[2]), of_piece.lambda1),
            select(clipped_, of_piece.interpolate(lambda2_[0], lambda2_[1], lambda2_[2]), of_piece.lambda2)};
    }

    static constexpr int kDistinct = kAlike ? 1 : kLanes<F>;
    NumberedTriangle triangle_[kDistinct];
    Double<F> dx_[3], dy_[3];  // edge i, from its first corner to its second, 1/256 pixel
    F e_[3], inverse_w_[3];
    F b_[3];  // E_i / w_i, whose shares are the coordinates
    Mask<F> clipped_;
    bool any_clipped_;
    F lambda1_[3], lambda2_[3];  // of the corners of clipped pieces
    Barycentric<F> here_;
    F perspective_depth_;
};

// Calls body(triangles) for the triangles of a group of pixels, and says whether it shows any.
template <class F, class Body>
CREVICE_INLINE bool with_triangles(const ScreenGeometry& geometry, Int<F> numbers, int x, int y,
                                   const Body& body) {
    const std::int32_t number = largest_of(numbers);
    if (number < 0) return false;
    if (all((numbers == Int<F>(number)) | (numbers < Int<F>(0)))) {
        body(TriangleLanes<F, true>(geometry, numbers, x, y));
    } else {
        if constexpr (kLanes < F >> 1) body(TriangleLanes<F, false>(geometry, numbers, x, y));
    }
    return true;
}

}  // namespace crevice
