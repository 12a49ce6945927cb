#include "ssao/compute/compute_ssao.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"

namespace crevice {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr int kGroupMemorySide = 2 * kAoGroup + 2 + 2 * kWidestApron;
constexpr std::size_t kGroupMemory = std::size_t{kGroupMemorySide} * kGroupMemorySide;
static_assert(kGroupMemory * sizeof(float) <= 32 * 1024);

// Pixels first to end - 1 of one axis; the border before the picture is -1.
struct Span {
    int first, end;
    int count() const { return end - first; }
};

// What `texels` from `texel` on see of an axis: the pixels under them with those right of and below the last,
// and the apron.
Span span_of(int texel, int texels, int map_texels, int pixels, int apron_px) {
    const int last_texel = std::min(texel + texels, map_texels);
    const auto at = [&](int edge) { return static_cast<int>(std::int64_t{edge} * pixels / map_texels); };
    return {std::max(at(texel) - apron_px, -1), std::min(at(last_texel) + 2 + apron_px, pixels + 2)};
}

// A depth source as LunaKernel wants it: the group's memory, and the map for what lies beyond. An index is of
// the memory, or -1 - index into the map.
template <class F>
struct GroupDepths {
    const Image<float>& map;
    const float* memory;  // columns.count() a row
    Span columns, rows;
    F strays = F(0);  // samples of this thread so far that read the map

    template <class G>
    CREVICE_INLINE Int<G> index_of(Int<G> x, Int<G> y) {
        const Int<G> column = x - Int<G>(columns.first), row = y - Int<G>(rows.first);
        const auto inside = (column >= Int<G>(0)) & (column < Int<G>(columns.count() - 1)) &
                            (row >= Int<G>(0)) & (row < Int<G>(rows.count() - 1));
        strays = strays + select(inside, G(0), G(1));
        const Int<G> in_map = WholeDepthMap{map}.index_of<G>(x, y);
        return select(inside, row * Int<G>(columns.count()) + column, Int<G>(-1) - in_map);
    }

    template <class G>
    CREVICE_INLINE Square<F> square_at(Int<G> index) const {
        using I = Int<G>;
        const auto stray = index < I(0);
        const Square<F> kept = gather_square(memory, columns.count(), select(stray, I(0), index));
        if (!any(stray)) return kept;
        const Square<F> read = WholeDepthMap{map}.square_at<F>(select(stray, I(-1) - index, I(0)));
        return {select(stray, read.upper_left, kept.upper_left),
                select(stray, read.upper_right, kept.upper_right),
                select(stray, read.lower_left, kept.lower_left),
                select(stray, read.lower_right, kept.lower_right)};
    }
};

// One dispatch of the AO pass, and the group of it whose first texel is (x, y).
struct AoDispatch {
    const LunaKernel& kernel;
    const RandomMap& random;
    int apron_px;

    MapReads run_group(GroupedAo& out, int x, int y, const Run& run) const {
        const AoInputs& in = kernel.inputs;
        const Size size = in.size();
        const Span columns = span_of(x, kAoGroup, size.width, in.picture.width, apron_px),
                   rows = span_of(y, kAoGroup, size.height, in.picture.height, apron_px);
        std::array<float, kGroupMemory> memory;
        for (int row = rows.first; row < rows.end; ++row)
            std::copy_n(in.depth_map.row(row + 1) + columns.first + 1, columns.count(),
                        memory.data() + (row - rows.first) * columns.count());
        // Here a shader waits until all its threads have got so far: GroupMemoryBarrierWithGroupSync().
        const int end_x = std::min(x + kAoGroup, size.width), end_y = std::min(y + kAoGroup, size.height);
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int texel_y = y; texel_y < end_y; ++texel_y) {
                for (int texel_x = x; texel_x < end_x; texel_x += kLanes<F>) {
                    const F z = load<F>(in.view_depth.row(texel_y) + texel_x);
                    const auto surface = z < F(kInfinity);
                    if (!any(surface)) continue;
                    GroupDepths<F> depths{in.depth_map, memory.data(), columns, rows};
                    store(out.ao.row(texel_y) + texel_x,
                          kernel.texels_at<F>(random, texel_x, texel_y, depths));
                    store(out.strays.row(texel_y) + texel_x, select(surface, depths.strays, F(0)));
                }
            }
        });
        MapReads reads{std::int64_t{columns.count()} * rows.count(), 0};
        for (int texel_y = y; texel_y < end_y; ++texel_y) {
            for (int texel_x = x; texel_x < end_x; ++texel_x) {
                if (!(in.view_depth.at(texel_x, texel_y) < kInfinity)) continue;
                reads.grouped += 4 * static_cast<std::int64_t>(out.strays.at(texel_x, texel_y));
                reads.direct += 4 * kernel.settings.samples;
            }
        }
        return reads;
    }
};

}  // namespace

GroupedAo luna_occlusion_in_groups(const AoInputs& inputs, const LunaSettings& settings, int apron_px,
                                   const Run& run) {
    validate(settings);
    if (apron_px < 0 || apron_px > kWidestApron)
        throw UsageError("apron: must lie in 0.." + std::to_string(kWidestApron) + " pixels (" +
                         std::to_string(apron_px) + "); choose another value");
    const TileMap tiles = ao_tiles(inputs, settings, run);
    GroupedAo out{Image<float>(inputs.size(), 1.0f), Image<float>(inputs.size(), 0.0f), {}};
    const LunaKernel kernel(inputs, settings);
    const RandomMap random = random_map(settings.seed, run);
    const AoDispatch dispatch{kernel, random, apron_px};
    std::vector<MapReads> reads(tiles.count());
    parallel_for(static_cast<int>(tiles.count()), run, [&](int i) {
        const int column = i % tiles.tiles.size.width, row = i / tiles.tiles.size.width;
        if (tiles.tiles.at(column, row) != TileWork::done) return;
        reads[static_cast<std::size_t>(i)] = dispatch.run_group(out, column * kAoGroup, row * kAoGroup, run);
    });
    for (const MapReads& group : reads) out.reads += group;
    return out;
}

}  // namespace crevice
