// What a shader is told about the pixels of a triangle that passed the depth test, and what it may compute
// from it.
#pragma once

#include "rasterizer/draw/screen_geometry.h"
#include "rasterizer/spaces.h"

namespace crevice {

// Perspective-correct barycentric coordinates for ScreenTriangle::vertex[1] and [2].
template <class F>
struct Barycentric {
    F lambda1, lambda2;

    // An attribute of the three vertices here. A constant attribute comes out bit-constant.
    CREVICE_INLINE F interpolate(float a0, float a1, float a2) const {
        return F(a0) + lambda1 * F(a1 - a0) + lambda2 * F(a2 - a0);
    }
    CREVICE_INLINE Vec3<F> interpolate(const glm::vec3& a0, const glm::vec3& a1, const glm::vec3& a2) const {
        return {interpolate(a0.x, a1.x, a2.x), interpolate(a0.y, a1.y, a2.y), interpolate(a0.z, a1.z, a2.z)};
    }
};

// The pixels (x, y) ... (x + lanes - 1, y).
template <class F>
struct Fragment {
    int x, y;
    Mask<F> passed;  // inside the triangle and through the depth test
    Barycentric<F> here;
    F view_depth;                   // scene units
    F b0, b1, b2;                   // E_i / w_i, whose shares are the coordinates
    const ClippedCorners* clipped;  // null: the triangle is whole

    // The coordinates `columns` and `rows` of pixels away, inside the triangle or not.
    CREVICE_INLINE Barycentric<F> away(const ScreenTriangle& t, int columns, int rows) const {
        const auto moved = [&](F b, int i) __attribute__((always_inline)) {
            const Edge e = triangle_edge(t, i);
            return b + F(static_cast<float>(e.per_column * columns + e.per_row * rows) *
                         t.inverse_w[static_cast<std::size_t>(i)]);
        };
        return barycentric(moved(b0, 0), moved(b1, 1), moved(b2, 2));
    }

    // 1 / (at0 + at1 + at2); lanes outside the triangle may meet a zero.
    CREVICE_INLINE F inverse_sum(F at0, F at1, F at2) const {
        return F(1) / select(passed, at0 + at1 + at2, F(1));
    }

    CREVICE_INLINE Barycentric<F> barycentric(F at0, F at1, F at2) const {
        return shares(at1, at2, inverse_sum(at0, at1, at2));
    }
    CREVICE_INLINE Barycentric<F> shares(F at1, F at2, F inverse) const {
        const Barycentric<F> of_piece{at1 * inverse, at2 * inverse};
        if (clipped == nullptr) return of_piece;
        const auto &l1 = clipped->lambda1, &l2 = clipped->lambda2;
        return {of_piece.interpolate(l1[0], l1[1], l1[2]), of_piece.interpolate(l2[0], l2[1], l2[2])};
    }
};

// What the shader is told, from the edge values of a group of pixels.
template <class F>
CREVICE_INLINE Fragment<F> fragment_at(const ScreenGeometry& geometry, const TriangleBlock& block,
                                       const ScreenTriangle& t, int x, int y, Mask<F> passed, F e0, F e1,
                                       F e2, F z_ndc) {
    const ClippedCorners* clipped =
        t.clipped < 0 ? nullptr : &block.clipped[static_cast<std::size_t>(t.clipped)];
    Fragment<F> f{
        x,      y, passed, {}, F(0), e0 * F(t.inverse_w[0]), e1 * F(t.inverse_w[1]), e2 * F(t.inverse_w[2]),
        clipped};
    const F inverse = f.inverse_sum(f.b0, f.b1, f.b2);
    f.here = f.shares(f.b1, f.b2, inverse);
    f.view_depth = geometry.rays.perspective ? F(t.doubled_area) * inverse
                                             : (z_ndc - F(geometry.depth_a)) / F(geometry.depth_b);
    return f;
}

// What the pixels (x, y) ... (x + lanes - 1, y) show at these view depths, view space.
template <class F>
CREVICE_INLINE Vec3<F> p_view_at(const ScreenGeometry& geometry, int x, int y, F view_depth) {
    const F u =
        (F(to_float(lane_index<F>() + Int<F>(x))) + F(0.5f)) / F(static_cast<float>(geometry.size.width));
    const F v = F((static_cast<float>(y) + 0.5f) / static_cast<float>(geometry.size.height));
    return geometry.rays.p_view(u, v, view_depth);
}

// The direction of the eye's ray through the same pixels, view space, with z = 1.
template <class F>
CREVICE_INLINE Vec3<F> view_ray_at(const ScreenGeometry& geometry, int x, int y) {
    if (!geometry.rays.perspective) return {F(0), F(0), F(1)};
    return p_view_at(geometry, x, y, F(1));
}

// The interpolated vertex normal of a fragment, view space, not normalised. On a back face it is turned to
// the eye where it points away; where it does not (the rim of a smooth closed mesh), it is the better normal
// as it stands.
template <class F>
CREVICE_INLINE Vec3<F> interpolated_normal(const ScreenGeometry& geometry, const ScreenTriangle& t,
                                           const Fragment<F>& f) {
    const std::vector<glm::vec3>& n_view = geometry.vertices.n_view;
    const Vec3<F> n = f.here.interpolate(n_view[t.vertex[0]], n_view[t.vertex[1]], n_view[t.vertex[2]]);
    if (!t.back_facing) return n;
    const F zero = F(0);
    const auto away = dot(n, view_ray_at<F>(geometry, f.x, f.y)) > zero;
    return select<F>(away, {zero - n.x, zero - n.y, zero - n.z}, n);
}

// A pixel's normal once it is known which triangle it shows; the background keeps (0, 0, 0).
template <class F>
CREVICE_INLINE Vec3<F> unit_normal(Vec3<F> interpolated) {
    return normalize_or<F>(interpolated, {F(0), F(0), F(0)});
}

// Fills a tile's part of an image, and the row padding after it.
template <class T>
void fill_tile(Image<T>& image, PixelRect tile, T value) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        T* row = image.row(y);
        for (int x = tile.x0; x < tile.x1; x += kRowAlignment)
            store(row + x, WideOf<T, kRowAlignment>(value));
    }
}

// image = value at the fragment's pixels that passed.
template <class F, class Value>
CREVICE_INLINE void store_where_passed(Value* row, const Fragment<F>& f, decltype(load<F>(row)) value) {
    store(row + f.x, select(f.passed, value, load<F>(row + f.x)));
}

}  // namespace crevice
