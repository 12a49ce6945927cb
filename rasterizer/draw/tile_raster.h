// The drawing of one tile: the kernel behind everything in visibility.h.
#pragma once

#include <algorithm>
#include <span>

#include "rasterizer/draw/drawing.h"
#include "rasterizer/draw/hidden_triangles.h"
#include "rasterizer/draw/lane_edge.h"
#include "rasterizer/draw/tiny_triangles.h"
#include "rasterizer/draw/visibility.h"

namespace crevice {

// Larger triangles are tested against blocks of 8x8 pixels first.
inline constexpr int kBlock_px = 8;

// One tile while it is drawn.
template <class F>
struct TileRaster {
    const Drawing& drawing;
    const PixelRect tile;
    TileRecord record = {};
    const DrawnPixels pixels = DrawnPixels(drawing);

    CREVICE_INLINE void draw_all(int number_of_tile, const Run& run) {
        HiddenTriangles hidden(tile);
        const ScreenGeometry& geometry = drawing.geometry;
        for (std::size_t b = 0; b < geometry.blocks.size(); ++b) {
            const TriangleBlock& block = geometry.blocks[b];
            const std::span<const std::uint32_t> indices = block.triangles_of_tile(number_of_tile);
            for (std::size_t i = 0; i < indices.size(); ++i) {
                if (i + kExpected < indices.size()) expect(block.triangles[indices[i + kExpected]]);
                const ScreenTriangle& t = block.triangles[indices[i]];
                const PixelRect reached = common_part(t.bounds, tile);
                if (reached.empty()) continue;
                const std::int32_t number = geometry.number_of(b, indices[i]);
                if (run.leaves_out(Skip::hidden_triangles)) {
                    if (is_hidden(hidden, t, number, reached)) continue;
                }
                const bool asks_holes = drawing.holes.may_be_in(t);
                if (!asks_holes && t.covered != 0 && reached == t.bounds) {
                    draw_tiny(t, number);
                } else if (asks_holes) {
                    draw<Form::with_holes>(block, t, number, reached);
                } else if (is_plain(t)) {
                    draw<Form::plain>(block, t, number, reached);
                } else {
                    draw<Form::whole>(block, t, number, reached);
                }
            }
        }
    }

    // A triangle that comes so many places later in a tile's list is asked for already: they lie far apart in memory.
    static constexpr std::size_t kExpected = 4;
    CREVICE_INLINE static void expect(const ScreenTriangle& t) {
        const char* const first = reinterpret_cast<const char*>(&t);
        __builtin_prefetch(first);
        __builtin_prefetch(first + sizeof t - 1);
    }

    CREVICE_INLINE bool is_hidden(HiddenTriangles& hidden, const ScreenTriangle& t, std::int32_t number,
                                  PixelRect reached) {
        hidden.count_triangle<F>(drawing.tested);
        const HiddenTriangles::Verdict verdict = hidden.verdict(drawing.test, drawing.format, t, reached);
        if (verdict.tied) note_tie(reached);
        if (!verdict.hidden) return false;
        ++record.hidden;
        if (drawing.hidden != nullptr) drawing.hidden->push_back(number);
        return true;
    }

    // What is known of a triangle when its kernel is compiled.
    enum class Form {
        with_holes,
        whole,
        plain,  // whole, and what nearly all are: drawn where nearest, and its depth's code is its own bits
    };
    CREVICE_INLINE bool is_plain(const ScreenTriangle& t) const {
        return drawing.test == DepthFunction::less && drawing.format == DepthFormat::d32f &&
               drawing.depth != nullptr && drawing.triangle != nullptr && t.depth_bias == 0 && t.z_low > 0 &&
               t.z_high <= 1;
    }

    CREVICE_INLINE void draw_tiny(const ScreenTriangle& t, std::int32_t number) {
        tiny_fragments(
            t, [&](int x, int y, float z_ndc) __attribute__((always_inline)) {
                const std::ptrdiff_t at = pixels.at(x, y);
                const std::int32_t code = depth_code(drawing.format, z_ndc, t.depth_bias),
                                   stored = pixels.tested[at];
                const bool passes = depth_passes<float>(drawing.test, code, stored);
                if (pixels.depth != nullptr) {
                    if (code == stored) note_tie({x, y, x + 1, y + 1});
                    if (passes) pixels.depth[at] = code;
                }
                if (pixels.triangle != nullptr && passes) pixels.triangle[at] = number;
            });
    }

    template <Form kForm>
    CREVICE_INLINE void draw(const TriangleBlock& block, const ScreenTriangle& t, std::int32_t number,
                             PixelRect rect) {
        if (t.small) {
            draw<kForm, Int<F>>(block, t, number, rect);
        } else {
            draw<kForm, Double<F>>(block, t, number, rect);
        }
    }

    // E is the type of the edge values: Int<F> for small triangles, Double<F> for the others.
    template <Form kForm, class E>
    CREVICE_INLINE void draw(const TriangleBlock& block, const ScreenTriangle& t, std::int32_t number,
                             PixelRect rect) {
        constexpr bool test_blocks = !std::is_same_v<E, Int<F>>;
        const LaneEdge<F, E> edges[3] = {LaneEdge<F, E>(triangle_edge(t, 0)),
                                         LaneEdge<F, E>(triangle_edge(t, 1)),
                                         LaneEdge<F, E>(triangle_edge(t, 2))};
        // A narrow triangle is one column of groups, wherever it starts; it must end within the tile.
        const bool narrow = rect.x1 - rect.x0 <= kBlock_px;
        const int start_x =
            narrow ? std::min(rect.x0, round_up(tile.x1, kBlock_px) - kBlock_px) : rect.x0 & -kBlock_px;
        constexpr int step_y = test_blocks ? kBlock_px : kSmallTriangle_px;
        // A group's rows are never cut apart: pictures' tiles and their parts begin at even rows.
        const int start_y = rect.y0 & -kGroupRows<F>;
        for (int block_y = test_blocks ? rect.y0 & -kBlock_px : start_y; block_y < rect.y1;
             block_y += step_y) {
            for (int block_x = start_x; block_x < rect.x1; block_x += kBlock_px) {
                const Reach reach = test_blocks ? reach_of(edges, block_x, block_y) : Reach::part;
                if (reach == Reach::nothing) continue;
                const int first_x = kLanes<F> == 1 ? std::max(block_x, rect.x0) : block_x;
                const PixelRect part = {first_x, std::max(block_y, start_y),
                                        std::min(block_x + kBlock_px, rect.x1),
                                        std::min(block_y + step_y, rect.y1)};
                for (int x = part.x0; x < part.x1; x += kGroupColumns<F>) {
                    if (reach == Reach::all) {
                        covered_column<kForm>(block, t, number, edges, x, part);
                    } else {
                        column<kForm>(block, t, number, edges, x, part);
                    }
                }
            }
        }
    }

    // How much of a block a triangle covers. Of each edge the most inner and the most outer pixel decide.
    enum class Reach { nothing, part, all };
    template <class E>
    static Reach reach_of(const LaneEdge<F, E> (&edges)[3], int x, int y) {
        constexpr std::int64_t last = kBlock_px - 1;
        Reach reach = Reach::all;
        for (const LaneEdge<F, E>& e : edges) {
            const std::int64_t first = e.at(x, y), across = last * e.edge.per_column,
                               down = last * e.edge.per_row;
            if (first + std::max(across, std::int64_t{0}) + std::max(down, std::int64_t{0}) < 0)
                return Reach::nothing;
            if (first + std::min(across, std::int64_t{0}) + std::min(down, std::int64_t{0}) < 0)
                reach = Reach::part;
        }
        return reach;
    }

    // The groups of pixels at x, one below the other.
    template <Form kForm, class E>
    CREVICE_INLINE void column(const TriangleBlock& block, const ScreenTriangle& t, std::int32_t number,
                               const LaneEdge<F, E> (&edges)[3], int x, PixelRect part) {
        auto c0 = edges[0].column(x, part.y0), c1 = edges[1].column(x, part.y0),
             c2 = edges[2].column(x, part.y0);
        for (int y = part.y0; y < part.y1; y += kGroupRows<F>) {
            const E e0 = c0.lanes, e1 = c1.lanes, e2 = c2.lanes;
            const Mask<F> covered = none_negative<F>(e0, e1, e2);
            if (any(covered)) {
                group<kForm>(block, t, number, x, y, covered, F(to_float(e1 + edges[1].threshold)),
                             F(to_float(e2 + edges[2].threshold)));
            }
            c0.next();
            c1.next();
            c2.next();
        }
    }

    // The same where all pixels are covered.
    template <Form kForm, class E>
    CREVICE_INLINE void covered_column(const TriangleBlock& block, const ScreenTriangle& t,
                                       std::int32_t number, const LaneEdge<F, E> (&edges)[3], int x,
                                       PixelRect part) {
        const Mask<F> covered = lane_index<F>() >= Int<F>(0);
        auto c1 = edges[1].whole_column(x, part.y0), c2 = edges[2].whole_column(x, part.y0);
        for (int y = part.y0; y < part.y1; y += kGroupRows<F>) {
            group<kForm>(block, t, number, x, y, covered, F(to_float(c1.lanes)), F(to_float(c2.lanes)));
            c1.next();
            c2.next();
        }
    }

    // Depth test of a group of covered pixels.
    template <Form kForm>
    CREVICE_INLINE void group(const TriangleBlock& block, const ScreenTriangle& t, std::int32_t number, int x,
                              int y, Mask<F> covered, F e1, F e2) {
        constexpr bool kPlain = kForm == Form::plain;
        const F z_ndc = z_ndc_at(t, e1, e2);
        const Int<F> code = kPlain ? float_bits(z_ndc) : depth_code(drawing.format, z_ndc, t.depth_bias);
        const GroupPlace<F> place(pixels, x, y, tile.y1);
        const Int<F> stored = place.load(pixels.tested);
        if constexpr (1 < kGroupRows<F>) covered = covered & place.inside();
        Mask<F> passed = covered & depth_passes<F>(kPlain ? DepthFunction::less : drawing.test, code, stored);
        Mask<F> tied = covered & (code == stored);
        if (!any(passed | tied)) return;
        if constexpr (kForm == Form::with_holes) {
            const Mask<F> kept = without_holes(block, t, x, y, passed, passed | tied);
            passed = passed & kept;
            tied = tied & kept;
        }
        if (kPlain || pixels.depth != nullptr) {
            if (any(tied)) note_tie({x, y, x + kGroupColumns<F>, y + kGroupRows<F>});
            place.store(pixels.depth, select(passed, code, stored));
        }
        if (kPlain || pixels.triangle != nullptr) {
            place.store(pixels.triangle, select(passed, Int<F>(number), place.load(pixels.triangle)));
        }
    }

    CREVICE_INLINE Mask<F> without_holes(const TriangleBlock& block, const ScreenTriangle& t, int x, int y,
                                         Mask<F> passed, Mask<F> asked) const {
        const Int<F> none(0), every(-1);
        std::int32_t kept[kLanes<F>], passes[kLanes<F>];
        store(kept, select(asked, every, none));
        store(passes, select(passed, every, none));
        for (int row = 0; row < kGroupRows<F>; ++row) {
            const int first = row * kGroupColumns<F>;
            drawing.holes.cut_out({block, t, x, y + row, kGroupColumns<F>, kept + first, passes + first});
        }
        return load<F>(kept) != none;
    }

    void note_tie(PixelRect rect) {
        rect.x0 &= -kRowAlignment;
        rect.y0 &= -2;
        rect.x1 = round_up(rect.x1, kRowAlignment);
        rect.y1 = std::min(round_up(rect.y1, 2), tile.y1);
        record.tied = around(record.tied, rect);
    }
};

}  // namespace crevice
