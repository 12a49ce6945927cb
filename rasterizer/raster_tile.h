// Pixels of one tile: coverage, depth test, and interpolation, eight pixels of a row at a time (or one, to
// step through). A pass gives a shader: what to do with the fragments that passed.
#pragma once

#include <algorithm>
#include <type_traits>

#include "rasterizer/depth_buffer.h"
#include "rasterizer/isa.h"
#include "rasterizer/parallel.h"
#include "rasterizer/screen_geometry.h"
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

// What a shader is told about the pixels (x, y) ... (x + lanes - 1, y).
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

// The direction of the eye's ray through the pixels (x, y) ... (x + lanes - 1, y), view space, with z = 1.
template <class F>
CREVICE_INLINE Vec3<F> view_ray_at(const ScreenGeometry& geometry, int x, int y) {
    if (!geometry.rays.perspective) return {F(0), F(0), F(1)};
    const F u =
        (F(to_float(lane_index<F>() + Int<F>(x))) + F(0.5f)) / F(static_cast<float>(geometry.size.width));
    const F v = F((static_cast<float>(y) + 0.5f) / static_cast<float>(geometry.size.height));
    return geometry.rays.p_view(u, v, F(1));
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

struct PixelRect {
    int x0, y0, x1, y1;  // x1 and y1 are one past the last
};

// Fills a tile's part of an image, and the row padding after it.
template <class T>
void fill_tile(Image<T>& image, PixelRect tile, T value) {
    for (int y = tile.y0; y < tile.y1; ++y)
        std::fill(image.row(y) + tile.x0, image.row(y) + round_up(tile.x1, kRowAlignment), value);
}

// image = value at the fragment's pixels that passed.
template <class F, class Value>
CREVICE_INLINE void store_where_passed(Value* row, const Fragment<F>& f, decltype(load<F>(row)) value) {
    store(row + f.x, select(f.passed, value, load<F>(row + f.x)));
}

// Triangles at most this wide and high evaluate their edges in 32-bit integers, larger ones in doubles, exact
// below 2^53. Both round the same integer to float, so the choice changes no bit.
inline constexpr int kSmallTriangle_px = 64;
// Triangles wider or higher than this are tested against blocks of 8x8 pixels first.
inline constexpr int kBlock_px = 8;

// The scalar that goes with the lanes of an edge function: 32-bit integers or doubles.
template <class E>
using EdgeScalar = std::conditional_t<std::is_same_v<E, std::int32_t> || std::is_same_v<E, WideInt<8>>,
                                      std::int32_t, double>;

// One edge over groups of pixels. Its values are kept less by the threshold, so that covered means not
// negative.
template <class E>
struct LaneEdge {
    Edge edge;
    E lane_offsets, per_row, threshold;

    CREVICE_INLINE LaneEdge(const Edge& of_triangle, E lane)
        : edge(of_triangle),
          lane_offsets(lane * E(static_cast<EdgeScalar<E>>(edge.per_column))),
          per_row(static_cast<EdgeScalar<E>>(edge.per_row)),
          threshold(static_cast<EdgeScalar<E>>(edge.threshold)) {}

    CREVICE_INLINE std::int64_t at(int x, int y) const {
        return edge.at_origin + edge.per_column * x + edge.per_row * y - edge.threshold;
    }
    CREVICE_INLINE E lanes(int x, int y) const {
        return E(static_cast<EdgeScalar<E>>(at(x, y))) + lane_offsets;
    }
};

// Whether all three are >= 0. Of integers one look at the joined sign bits is enough.
template <class F, class E>
CREVICE_INLINE Mask<F> none_negative(E a, E b, E c) {
    if constexpr (std::is_same_v<E, Int<F>>) {
        return (a | b | c) >= E(0);
    } else {
        return (a >= E(0)) & (b >= E(0)) & (c >= E(0));
    }
}

// What the shader is told, from the edge values of a group.
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

// Depth test and shading of a group of covered pixels.
template <class F, class Depth, class Shader>
CREVICE_INLINE void raster_group(const ScreenGeometry& geometry, const TriangleBlock& block,
                                 const ScreenTriangle& t, int x, int y, Mask<F> covered, F e0, F e1, F e2,
                                 DepthFunction test, Depth& depth, const Shader& shader) {
    // The small terms first: one rounding at the size of z instead of two.
    const F z_ndc = F(t.z0) + (e1 * F(t.z_per_e1) + e2 * F(t.z_per_e2));
    const Int<F> code = depth_code(depth.format, z_ndc, t.depth_bias);
    const auto stored_at = depth.codes.row(y) + x;
    const Int<F> stored = load<F>(stored_at);
    const Mask<F> passed = covered & depth_passes<F>(test, code, stored);
    if (!any(passed)) return;
    if constexpr (!std::is_const_v<Depth>) store(stored_at, select(passed, code, stored));
    shader.template fragment<F>(t, fragment_at<F>(geometry, block, t, x, y, passed, e0, e1, e2, z_ndc));
}

template <class F, class E, class Depth, class Shader>
CREVICE_INLINE void raster_triangle(const ScreenGeometry& geometry, const TriangleBlock& block,
                                    const ScreenTriangle& t, PixelRect rect, bool test_blocks,
                                    DepthFunction test, Depth& depth, const Shader& shader) {
    const E lane = []() __attribute__((always_inline)) {
        if constexpr (std::is_same_v<E, Int<F>>) {
            return lane_index<F>();
        } else {
            return to_double(lane_index<F>());
        }
    }();
    const LaneEdge<E> edges[3] = {
        {triangle_edge(t, 0), lane}, {triangle_edge(t, 1), lane}, {triangle_edge(t, 2), lane}};
    const auto block_missed = [&](int x, int y) {
        for (const LaneEdge<E>& e : edges) {
            const int inner_x = x + (e.edge.per_column > 0 ? kBlock_px - 1 : 0);
            const int inner_y = y + (e.edge.per_row > 0 ? kBlock_px - 1 : 0);
            if (e.at(inner_x, inner_y) < 0) return true;
        }
        return false;
    };
    for (int block_y = rect.y0 & -kBlock_px; block_y < rect.y1; block_y += kBlock_px) {
        for (int block_x = rect.x0 & -kBlock_px; block_x < rect.x1; block_x += kBlock_px) {
            if (test_blocks && block_missed(block_x, block_y)) continue;
            const int first_y = std::max(block_y, rect.y0), end_y = std::min(block_y + kBlock_px, rect.y1);
            for (int x = block_x; x < block_x + kBlock_px; x += kLanes<F>) {
                if (kLanes<F> == 1 && (x < rect.x0 || x >= rect.x1)) continue;
                E e0 = edges[0].lanes(x, first_y), e1 = edges[1].lanes(x, first_y),
                  e2 = edges[2].lanes(x, first_y);
                for (int y = first_y; y < end_y; ++y) {
                    const Mask<F> covered = none_negative<F>(e0, e1, e2);
                    if (any(covered)) {
                        raster_group<F>(geometry, block, t, x, y, covered,
                                        F(to_float(e0 + edges[0].threshold)),
                                        F(to_float(e1 + edges[1].threshold)),
                                        F(to_float(e2 + edges[2].threshold)), test, depth, shader);
                    }
                    e0 = e0 + edges[0].per_row;
                    e1 = e1 + edges[1].per_row;
                    e2 = e2 + edges[2].per_row;
                }
            }
        }
    }
}

// The part of the tile that a triangle's bounding box reaches.
inline PixelRect clipped_to_tile(const ScreenTriangle& t, PixelRect tile) {
    const PixelSpan columns =
        covered_centres(std::min({t.x[0], t.x[1], t.x[2]}), std::max({t.x[0], t.x[1], t.x[2]}));
    const PixelSpan rows = covered_centres(t.y[0], std::max(t.y[1], t.y[2]));
    return {std::max(columns.first, tile.x0), std::max(rows.first, tile.y0),
            std::min(columns.last + 1, tile.x1), std::min(rows.last + 1, tile.y1)};
}

inline bool is_small(const ScreenTriangle& t) {
    const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
    constexpr std::int32_t limit = kSmallTriangle_px * kSubpixelSteps;
    return right - left <= limit && std::max(t.y[1], t.y[2]) - t.y[0] <= limit;
}

template <class F, class Depth, class Shader>
CREVICE_INLINE void raster_tile(const ScreenGeometry& geometry, int tile, DepthFunction test, Depth& depth,
                                const Shader& shader) {
    const int x0 = tile % geometry.tiles.width * geometry.tile_size;
    const int y0 = tile / geometry.tiles.width * geometry.tile_size;
    const PixelRect tile_rect = {x0, y0, std::min(x0 + geometry.tile_size, geometry.size.width),
                                 std::min(y0 + geometry.tile_size, geometry.size.height)};
    shader.begin_tile(tile_rect);
    for (const TriangleBlock& block : geometry.blocks) {
        const std::uint32_t end = block.first_of_tile[static_cast<std::size_t>(tile) + 1];
        for (std::uint32_t i = block.first_of_tile[static_cast<std::size_t>(tile)]; i < end; ++i) {
            const ScreenTriangle& t = block.triangles[block.triangle_of_tile[i]];
            const PixelRect rect = clipped_to_tile(t, tile_rect);
            if (is_small(t)) {
                raster_triangle<F, Int<F>>(geometry, block, t, rect, false, test, depth, shader);
            } else {
                raster_triangle<F, Double<F>>(geometry, block, t, rect, true, test, depth, shader);
            }
        }
    }
    shader.template finish_tile<F>(tile_rect);
}

// Draws all triangles, tile by tile, on all threads. Depth is DepthBuffer, or const DepthBuffer: then depths
// are tested but not written. Shader is a class with three const members:
//   begin_tile(rect)                  before the first triangle of a tile: fills what the pass writes,
//                                     padding included
//   fragment<F>(triangle, fragment)   writes only where fragment.passed holds
//   finish_tile<F>(rect)              after the last triangle of a tile
template <class Depth, class Shader>
void rasterize(const ScreenGeometry& geometry, DepthFunction test, Depth& depth, const Shader& shader,
               const Run& run) {
    parallel_for(geometry.tiles.width * geometry.tiles.height, run, [&](int tile) {
        run_kernel(
            run, [&](auto tag) __attribute__((always_inline)) {
                raster_tile<typename decltype(tag)::type>(geometry, tile, test, depth, shader);
            });
    });
}

}  // namespace crevice
