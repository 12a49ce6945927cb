#include "rasterizer/draw/triangle_blocks.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "rasterizer/base/run.h"
#include "rasterizer/draw/clip.h"
#include "rasterizer/draw/setup_lanes.h"

namespace crevice {

namespace {

// Appends triangles to a block, then sorts their indices by tile.
class BlockBuilder {
 public:
    BlockBuilder(const ScreenGeometry& geometry, const SetupSettings& setup, bool leaves_out_off_screen,
                 TriangleBlock& block)
        : geometry_(geometry),
          setup_(setup),
          leaves_out_off_screen_(leaves_out_off_screen),
          tile_bits_(std::countr_zero(static_cast<unsigned>(geometry.tile_size))),
          block_(block) {}

    void reserve(std::size_t triangles) {
        block_.triangles.reserve(triangles);
        entries_.reserve(triangles);
    }

    // All triangles of a source, as many at a time as there are lanes.
    template <class F>
    CREVICE_INLINE void add(const BlockSource& source) {
        Survivors<F> survivors;
        for (std::size_t i = 0; i < source.triangles.size(); i += kLanes<F>)
            add_group<F>(source, i, survivors);
        set_up(source, survivors);
    }

    void finish() {
        const auto tile_count = static_cast<std::size_t>(geometry_.tiles.width * geometry_.tiles.height);
        block_.first_of_tile.assign(tile_count + 1, 0);
        for (const Entry& entry : entries_) ++block_.first_of_tile[entry.tile + 1];
        for (std::size_t t = 0; t < tile_count; ++t) block_.first_of_tile[t + 1] += block_.first_of_tile[t];
        block_.triangle_of_tile.resize(entries_.size());
        std::vector<std::uint32_t> next(block_.first_of_tile.begin(), block_.first_of_tile.end() - 1);
        for (const Entry& entry : entries_) block_.triangle_of_tile[next[entry.tile]++] = entry.triangle;
    }

 private:
    struct Entry {
        std::uint32_t tile, triangle;
    };

    // Triangles that may be drawn and are whole, until there are as many as lanes.
    template <class F>
    struct Survivors {
        std::int32_t vertex[3][kLanes<F>] = {}, covered[kLanes<F>] = {};
        int count = 0;
    };

    // Looks at the triangles from `first` on, one a lane, and sets up what is left of them when the lanes are full.
    template <class F>
    CREVICE_INLINE void add_group(const BlockSource& source, std::size_t first, Survivors<F>& survivors) {
        using I = Int<F>;
        const auto left = static_cast<int>(source.triangles.size() - first);
        const I triangle = min_of(lane_index<F>(), I(left - 1));
        const auto* const indices = reinterpret_cast<const std::int32_t*>(source.triangles[first].data());
        const auto vertex_of = [&](int corner) __attribute__((always_inline)) {
            const I in_mesh = gather(indices + (source.mirrored ? 2 - corner : corner), triangle * I(3));
            return in_mesh + I(static_cast<std::int32_t>(source.first_vertex));
        };
        const I vertex[3] = {vertex_of(0), vertex_of(1), vertex_of(2)};
        const I outside[3] = {outside_of<F>(vertex[0]), outside_of<F>(vertex[1]), outside_of<F>(vertex[2])};
        const I everywhere = outside[0] & outside[1] & outside[2],
                somewhere = outside[0] | outside[1] | outside[2];
        const auto has = [](I bits, std::int32_t any_of) __attribute__((always_inline)) {
            return (bits & I(any_of)) != I(0);
        };
        Mask<F> wanted = (lane_index<F>() < I(left)) & !has(somewhere, kNotANumber);
        if (leaves_out_off_screen_) {
            const Mask<F> beyond = wanted & has(everywhere, kOutsideOneSide);
            if (any(beyond)) {
                std::int32_t is_beyond[kLanes<F>];
                store(is_beyond, select(beyond, I(1), I(0)));
                for (const std::int32_t one : is_beyond) block_.off_screen += static_cast<std::size_t>(one);
                wanted = wanted & !beyond;
            }
        }
        const Mask<F> clipped = wanted & has(somewhere, kNeedsClipping);
        const SnappedCorner<F> a = snapped_corner<F>(vertex[0]), b = snapped_corner<F>(vertex[1]),
                               c = snapped_corner<F>(vertex[2]);
        SnappedTriangles<F> snapped(a, b, c, wanted & !clipped, setup_.cull_back_faces);
        const I covered = snapped.drop_uncovering(a, b, c);
        std::uint32_t some = lane_bits(snapped.drawn | clipped);
        if (some == 0) return;
        const std::uint32_t needs_clipping = lane_bits(clipped);
        std::int32_t index[3][kLanes<F>], covered_of[kLanes<F>];
        for (std::size_t i = 0; i < 3; ++i) store(index[i], vertex[i]);
        store(covered_of, covered);
        for (; some != 0; some &= some - 1) {
            const int lane = std::countr_zero(some);
            if ((needs_clipping >> lane & 1) != 0) {
                set_up(source, survivors);
                add_clipped(source, {static_cast<std::uint32_t>(index[0][lane]),
                                     static_cast<std::uint32_t>(index[1][lane]),
                                     static_cast<std::uint32_t>(index[2][lane])});
                continue;
            }
            for (int i = 0; i < 3; ++i) survivors.vertex[i][survivors.count] = index[i][lane];
            survivors.covered[survivors.count] = covered_of[lane];
            if (++survivors.count == kLanes<F>) set_up(source, survivors);
        }
    }

    // Sets up the survivors and leaves none.
    template <class F>
    CREVICE_INLINE void set_up(const BlockSource& source, Survivors<F>& survivors) {
        using I = Int<F>;
        const int count = survivors.count;
        if (count == 0) return;
        survivors.count = 0;
        // The lanes after the last repeat the first.
        const Mask<F> filled = lane_index<F>() < I(count);
        I vertex[3];
        for (int i = 0; i < 3; ++i) {
            const std::int32_t* const given = survivors.vertex[i];
            vertex[i] = select(filled, load<F>(given), I(given[0]));
        }
        const LaneCorner<F> corners[3] = {corner_of<F>(vertex[0], 0), corner_of<F>(vertex[1], 1),
                                          corner_of<F>(vertex[2], 2)};
        const SetUpTriangles<F> set_up(SetupLanes<F>(corners, filled, setup_.cull_back_faces));
        for (int lane = 0; lane < count; ++lane) {
            ScreenTriangle& t = block_.triangles.add();
            set_up.write(lane, setup_, t);
            t.covered = static_cast<std::uint16_t>(survivors.covered[lane]);
            const std::array<std::uint8_t, 3> order = set_up.order(lane);
            for (std::size_t i = 0; i < 3; ++i)
                t.vertex[i] = static_cast<std::uint32_t>(survivors.vertex[order[i]][lane]);
            enter(source, t);
        }
    }

    template <class F>
    CREVICE_INLINE Int<F> outside_of(Int<F> vertex) const {
        return gather(geometry_.vertices.projected.outside.data(), vertex);
    }
    template <class F>
    CREVICE_INLINE SnappedCorner<F> snapped_corner(Int<F> vertex) const {
        const ProjectedVertices& v = geometry_.vertices.projected;
        return {gather(v.x.data(), vertex), gather(v.y.data(), vertex)};
    }
    template <class F>
    CREVICE_INLINE LaneCorner<F> corner_of(Int<F> vertex, int number) const {
        const ProjectedVertices& v = geometry_.vertices.projected;
        return {gather(v.x.data(), vertex),
                gather(v.y.data(), vertex),
                gather(v.x_rest.data(), vertex),
                gather(v.y_rest.data(), vertex),
                gather(v.z_ndc.data(), vertex),
                gather(v.inverse_w.data(), vertex),
                Int<F>(number)};
    }

    void add_clipped(const BlockSource& source, const std::array<std::uint32_t, 3>& index) {
        std::array<glm::dvec4, 3> p_clip;
        std::array<ProjectedVertex, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            p_clip[i] = source.exact != nullptr
                            ? source.exact->at(source.instance, index[i] - source.first_vertex)
                            : glm::dvec4(geometry_.vertices.p_clip[index[i]]);
            corners[i] = geometry_.vertices.projected[index[i]];
        }
        const ClippedPolygon polygon = clip_triangle(p_clip, geometry_.size, geometry_.depth_range);
        std::array<ProjectedVertex, kMaxClippedVertices> projected;
        for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
            // A vertex inside all planes keeps the position its unclipped neighbours use. (One on the guard
            // band may be outside in float and not be moved in double: it has no position yet.)
            const ClippedVertex& v = polygon.vertices[i];
            const ProjectedVertex* corner =
                v.original >= 0 ? &corners[static_cast<std::size_t>(v.original)] : nullptr;
            const bool keeps = corner != nullptr && (corner->outside & kNeedsClipping) == 0;
            projected[i] = keeps ? *corner : project_clipped(v, geometry_.size);
        }
        for (std::size_t i = 2; i < static_cast<std::size_t>(polygon.count); ++i) {
            const std::array<std::size_t, 3> piece = {0, i - 1, i};
            ClippedCorners lambdas;
            for (std::size_t k = 0; k < 3; ++k) {
                lambdas.lambda1[k] = static_cast<float>(polygon.vertices[piece[k]].lambda1);
                lambdas.lambda2[k] = static_cast<float>(polygon.vertices[piece[k]].lambda2);
            }
            const std::optional<SetUpTriangle> set_up =
                set_up_triangle({&projected[piece[0]], &projected[piece[1]], &projected[piece[2]]}, setup_);
            if (set_up) add_piece(source, index, *set_up, lambdas);
        }
    }

    // The corners of the piece were reordered; the submitted triangle keeps its order.
    void add_piece(const BlockSource& source, const std::array<std::uint32_t, 3>& index,
                   const SetUpTriangle& set_up, const ClippedCorners& lambdas) {
        ScreenTriangle& t = block_.triangles.add();
        t = set_up.triangle;
        t.vertex = index;
        t.clipped = static_cast<std::int32_t>(block_.clipped.size());
        ClippedCorners& reordered = block_.clipped.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            reordered.lambda1[i] = lambdas.lambda1[set_up.order[i]];
            reordered.lambda2[i] = lambdas.lambda2[set_up.order[i]];
        }
        enter(source, t);
    }

    // The last triangle, into the bounds of its block and the tiles that it may touch.
    void enter(const BlockSource& source, ScreenTriangle& t) {
        t.instance = source.instance;
        t.material = source.material;
        block_.z_lowest = std::min(block_.z_lowest, static_cast<double>(t.z_low) + t.depth_bias);
        block_.z_highest = std::max(block_.z_highest, static_cast<double>(t.z_high) + t.depth_bias);
        const int right = std::min(t.bounds.x1, geometry_.size.width) - 1,
                  bottom = std::min(t.bounds.y1, geometry_.size.height) - 1;
        if (right < 0 || bottom < 0 || t.bounds.x0 > right || t.bounds.y0 > bottom) return;
        const int first_x = std::max(t.bounds.x0, 0) >> tile_bits_, last_x = right >> tile_bits_,
                  first_y = std::max(t.bounds.y0, 0) >> tile_bits_, last_y = bottom >> tile_bits_;
        const auto triangle = static_cast<std::uint32_t>(block_.triangles.size() - 1);
        const bool one_tile = first_x == last_x && first_y == last_y;
        for (int y = first_y; y <= last_y; ++y) {
            for (int x = first_x; x <= last_x; ++x) {
                if (!one_tile && misses_tile(t, x << tile_bits_, y << tile_bits_)) continue;
                entries_.push_back({static_cast<std::uint32_t>(y * geometry_.tiles.width + x), triangle});
            }
        }
    }

    // True when one edge has every pixel centre of the tile on its outer side: its most inner corner decides.
    bool misses_tile(const ScreenTriangle& t, int x, int y) const {
        const int last = geometry_.tile_size - 1;
        for (int i = 0; i < 3; ++i) {
            const Edge e = triangle_edge(t, i);
            const int inner_x = x + (e.per_column > 0 ? last : 0), inner_y = y + (e.per_row > 0 ? last : 0);
            if (e.at_origin + e.per_column * inner_x + e.per_row * inner_y < e.threshold) return true;
        }
        return false;
    }

    const ScreenGeometry& geometry_;
    const SetupSettings& setup_;
    const bool leaves_out_off_screen_;
    const int tile_bits_;  // a tile's size is this power of two
    TriangleBlock& block_;
    std::vector<Entry> entries_;
};

}  // namespace

TriangleBlock build_block(const ScreenGeometry& geometry, std::span<const BlockSource> sources,
                          const SetupSettings& setup, const Run& run) {
    TriangleBlock block;
    BlockBuilder builder(geometry, setup, run.leaves_out(Skip::off_screen_triangles), block);
    std::size_t triangles = 0;
    for (const BlockSource& source : sources) triangles += source.triangles.size();
    builder.reserve(triangles);
    run_narrow_kernel(run, [&]<class F>(Lanes<F>) {
        for (const BlockSource& source : sources) builder.add<F>(source);
    });
    builder.finish();
    return block;
}

}  // namespace crevice
