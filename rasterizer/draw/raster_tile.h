// Pixels of one tile: coverage, depth test, and interpolation, eight pixels of a row at a time (or one, to
// step through). A pass gives a shader: what to do with the fragments that passed.
#pragma once

#include <algorithm>
#include <concepts>
#include <type_traits>

#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "rasterizer/draw/fragment.h"
#include "rasterizer/draw/hidden_triangles.h"

namespace crevice {

// Small triangles evaluate their edges in 32-bit integers, larger ones in doubles, exact below 2^53. Both round
// the same integer to float, so the choice changes no bit. Larger ones are tested against blocks of 8x8 pixels
// first.
inline constexpr int kBlock_px = 8;

// What became of a tile's triangles.
struct TileRecord {
    std::uint32_t triangles = 0;  // entries of its lists
    std::uint32_t hidden = 0;     // of those, left out as a whole
    PixelRect tied = {};  // around the pixels where a fragment's depth equalled the stored one, or might
                          // have; begins and ends with groups of kRowAlignment pixels; mostly empty
};

// The scalar that goes with the lanes of an edge function: 32-bit integers or doubles.
template <class E>
using EdgeScalar = std::conditional_t<std::is_same_v<E, std::int32_t> || std::is_same_v<E, WideInt<4>> ||
                                          std::is_same_v<E, WideInt<8>>,
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

// Whether all three, whole numbers and none of them -0, are >= 0: one look at the joined sign bits is enough.
template <class F, class E>
CREVICE_INLINE Mask<F> none_negative(E a, E b, E c) {
    if constexpr (std::is_same_v<E, Int<F>>) {
        return (a | b | c) >= E(0);
    } else {
        return (upper_bits(a) | upper_bits(b) | upper_bits(c)) >= Int<F>(0);
    }
}

// A shader that may drop fragments, for cut-outs. What it drops leaves no depth, so it hides nothing and ties
// with nothing.
template <class Shader>
concept DropsFragments = requires(const Shader& shader, const ScreenTriangle& t, const Fragment<float>& f) {
    { shader.template kept<float>(t, f) } -> std::same_as<bool>;
};

// One tile while it is drawn.
template <class F, class Depth, class Shader>
struct TileRaster {
    const ScreenGeometry& geometry;
    const DepthFunction test;
    Depth& depth;
    const Shader& shader;
    const PixelRect tile;
    TileRecord& record;

    // Depth test and shading of a group of covered pixels.
    CREVICE_INLINE void group(const TriangleBlock& block, const ScreenTriangle& t, int x, int y,
                              Mask<F> covered, F e0, F e1, F e2) {
        // The small terms first: one rounding at the size of z instead of two.
        const F z_ndc = F(t.z0) + (e1 * F(t.z_per_e1) + e2 * F(t.z_per_e2));
        const Int<F> code = depth_code(depth.format, z_ndc, t.depth_bias);
        const auto stored_at = depth.codes.row(y) + x;
        const Int<F> stored = load<F>(stored_at);
        Mask<F> passed = covered & depth_passes<F>(test, code, stored);
        if constexpr (DropsFragments<Shader>) {
            const Mask<F> asked = passed | (covered & (code == stored));
            if (!any(asked)) return;
            covered = asked & shader.template kept<F>(
                                  t, fragment_at<F>(geometry, block, t, x, y, asked, e0, e1, e2, z_ndc));
            passed = passed & covered;
        }
        if constexpr (!std::is_const_v<Depth>) {
            const Mask<F> tied = covered & (code == stored);
            if (!any(passed | tied)) return;
            if (any(tied)) note_tie({x, y, x + kLanes<F>, y + 1});
            store(stored_at, select(passed, code, stored));
        }
        if (!any(passed)) return;
        shader.template fragment<F>(t, fragment_at<F>(geometry, block, t, x, y, passed, e0, e1, e2, z_ndc));
    }

    void note_tie(PixelRect pixels) {
        pixels.x0 &= -kRowAlignment;
        pixels.x1 = round_up(pixels.x1, kRowAlignment);
        record.tied = around(record.tied, pixels);
    }

    // E is the type of the edge values: Int<F> for small triangles, Double<F> for the others.
    template <class E>
    CREVICE_INLINE void triangle(const TriangleBlock& block, const ScreenTriangle& t, PixelRect rect) {
        constexpr bool test_blocks = !std::is_same_v<E, Int<F>>;
        const E lane = []() __attribute__((always_inline)) {
            if constexpr (test_blocks) {
                return to_double(lane_index<F>());
            } else {
                return lane_index<F>();
            }
        }
        ();
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
        // A narrow triangle is one column of groups, wherever it starts; it must end within the tile.
        const bool narrow = rect.x1 - rect.x0 <= kBlock_px;
        const int start_x =
            narrow ? std::min(rect.x0, round_up(tile.x1, kBlock_px) - kBlock_px) : rect.x0 & -kBlock_px;
        constexpr int step_y = test_blocks ? kBlock_px : kSmallTriangle_px;
        for (int block_y = test_blocks ? rect.y0 & -kBlock_px : rect.y0; block_y < rect.y1;
             block_y += step_y) {
            for (int block_x = start_x; block_x < rect.x1; block_x += kBlock_px) {
                if (test_blocks && block_missed(block_x, block_y)) continue;
                const int first_y = std::max(block_y, rect.y0), end_y = std::min(block_y + step_y, rect.y1);
                for (int x = block_x; x < block_x + kBlock_px; x += kLanes<F>) {
                    if (kLanes<F> == 1 && (x < rect.x0 || x >= rect.x1)) continue;
                    E e0 = edges[0].lanes(x, first_y), e1 = edges[1].lanes(x, first_y),
                      e2 = edges[2].lanes(x, first_y);
                    for (int y = first_y; y < end_y; ++y) {
                        const Mask<F> covered = none_negative<F>(e0, e1, e2);
                        if (any(covered)) {
                            group(block, t, x, y, covered, F(to_float(e0 + edges[0].threshold)),
                                  F(to_float(e1 + edges[1].threshold)), F(to_float(e2 + edges[2].threshold)));
                        }
                        e0 = e0 + edges[0].per_row;
                        e1 = e1 + edges[1].per_row;
                        e2 = e2 + edges[2].per_row;
                    }
                }
            }
        }
    }
};

template <class F, class Depth, class Shader>
CREVICE_INLINE TileRecord raster_tile(const ScreenGeometry& geometry, int tile, PixelRect part,
                                      DepthFunction test, Depth& depth, const Shader& shader,
                                      const Run& run) {
    TileRecord record;
    record.triangles = geometry.triangles_of_tile(tile);
    if (record.triangles == 0 && run.leaves_out(Skip::empty_tiles)) {
        shader.empty_tile(part);
        return record;
    }
    shader.begin_tile(part);
    TileRaster<F, Depth, Shader> raster{geometry, test, depth, shader, part, record};
    HiddenTriangles hidden(part);
    for (const TriangleBlock& block : geometry.blocks) {
        for (const std::uint32_t index : block.triangles_of_tile(tile)) {
            const ScreenTriangle& t = block.triangles[index];
            const PixelRect reached = common_part(t.bounds, part);
            if (reached.empty()) continue;
            if (run.leaves_out(Skip::hidden_triangles)) {
                hidden.count_triangle<F>(depth.codes);
                const HiddenTriangles::Verdict verdict = hidden.verdict(test, depth.format, t, reached);
                if (verdict.tied) raster.note_tie(reached);
                if (verdict.hidden) {
                    ++record.hidden;
                    continue;
                }
            }
            if (t.small) {
                raster.template triangle<Int<F>>(block, t, reached);
            } else {
                raster.template triangle<Double<F>>(block, t, reached);
            }
        }
    }
    shader.template finish_tile<F>(part);
    return record;
}

// Draws the triangles of the wanted tiles, tile by tile, on all threads. Depth is DepthBuffer, or const
// DepthBuffer: then depths are tested but not written. Shader is a class with these const members:
//   wanted_part(tile, rect)           the part of a tile's rectangle to be drawn, its columns in whole groups of
//                                     kRowAlignment; may be empty
//   empty_tile(part)                  instead of the next three, for a tile that no triangle touches
//   begin_tile(part)                  before the first triangle of a tile: fills what the pass writes,
//                                     padding included
//   fragment<F>(triangle, fragment)   writes only where fragment.passed holds
//   kept<F>(triangle, fragment)       optional: which fragments are not cut out, asked before their depths
//                                     are written. Only lanes where fragment.passed holds matter. It must
//                                     depend on triangle, pixel and barycentric coordinates alone, the same way
//                                     in all passes of a view: then EQUAL finds what the first pass left
//   finish_tile<F>(part)              after the last triangle of a tile
// Returns what became of each tile's triangles.
template <class Depth, class Shader>
std::vector<TileRecord> rasterize(const ScreenGeometry& geometry, DepthFunction test, Depth& depth,
                                  const Shader& shader, const Run& run) {
    std::vector<TileRecord> records(static_cast<std::size_t>(geometry.tile_count()));
    parallel_for(geometry.tile_count(), run, [&](int tile) {
        const PixelRect part = shader.wanted_part(tile, geometry.tile_rect(tile));
        if (part.empty()) return;
        run_kernel(run, [&]<class F>(Lanes<F>) {
            records[static_cast<std::size_t>(tile)] =
                raster_tile<F>(geometry, tile, part, test, depth, shader, run);
        });
    });
    return records;
}

}  // namespace crevice
