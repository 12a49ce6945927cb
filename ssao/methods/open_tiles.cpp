#include "ssao/methods/open_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"

namespace crevice {

namespace {

constexpr float kInfiniteDepth = std::numeric_limits<float>::infinity();
// Side of the blocks of the depth map whose ranges are kept, pixels.
constexpr int kBlock = 16;

// Columns and rows, the last ones included.
struct Window {
    int left, top, right, bottom;
};

// What a part of an image holds, infinities and NaN left out. In the AO map they are background; in the depth
// map every filter that touches one gives infinity or NaN, which is in front of nothing.
struct Range {
    float nearest = kInfiniteDepth, farthest = -kInfiniteDepth;

    bool empty() const { return !(nearest <= farthest); }
    void include(const Range& other) {
        nearest = std::min(nearest, other.nearest);
        farthest = std::max(farthest, other.farthest);
    }
};

template <class F>
CREVICE_INLINE void include_row(const float* row, int first, int end, F& nearest, F& farthest) {
    for (int x = first; x + kLanes<F> <= end; x += kLanes<F>) {
        const F z = load<F>(row + x);
        nearest = min_of(z, nearest);  // a NaN in the first place is passed over
        farthest = max_of(select(z < F(kInfiniteDepth), z, farthest), farthest);
    }
}

template <class F>
CREVICE_INLINE Range range_in(const Image<float>& image, const Window& window) {
    constexpr int kLanesOfF = kLanes<F>;
    const int end = window.right + 1, whole = end - (end - window.left) % kLanesOfF;
    F near_lanes = F(kInfiniteDepth), far_lanes = F(-kInfiniteDepth);
    float nearest[kLanesOfF + 1], farthest[kLanesOfF + 1];
    nearest[kLanesOfF] = kInfiniteDepth;
    farthest[kLanesOfF] = -kInfiniteDepth;
    for (int y = window.top; y <= window.bottom; ++y) {
        include_row<F>(image.row(y), window.left, whole, near_lanes, far_lanes);
        include_row<float>(image.row(y), whole, end, nearest[kLanesOfF], farthest[kLanesOfF]);
    }
    store(nearest, near_lanes);
    store(farthest, far_lanes);
    return {*std::min_element(nearest, nearest + kLanesOfF + 1),
            *std::max_element(farthest, farthest + kLanesOfF + 1)};
}

// The ranges of the square cells that an image divides into, in those rows of cells that are wanted.
Image<Range> cell_ranges(const Image<float>& image, int side, const std::vector<char>& wanted_rows,
                         const Run& run) {
    const Size size = image.size, cells = {(size.width + side - 1) / side, (size.height + side - 1) / side};
    Image<Range> ranges(cells, Range{});
    parallel_for(cells.height, run, [&](int row) {
        if (!wanted_rows[static_cast<std::size_t>(row)]) return;
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int column = 0; column < cells.width; ++column) {
                const int left = column * side, top = row * side;
                ranges.at(column, row) = range_in<F>(image, {left, top, std::min(left + side, size.width) - 1,
                                                             std::min(top + side, size.height) - 1});
            }
        });
    });
    return ranges;
}

// The union of the cells that a window of the image touches.
Range range_over(const Image<Range>& cells, int side, const Window& window) {
    Range result;
    for (int row = window.top / side; row <= window.bottom / side; ++row) {
        for (int column = window.left / side; column <= window.right / side; ++column)
            result.include(cells.at(column, row));
    }
    return result;
}

// The pixels of the depth map that the samples of one axis may be compared with, for texels [first, last] of
// `texels` whose samples move up to reach_px; [0, pixels + 2] in the map's own columns or rows.
std::pair<int, int> map_pixels(int first, int last, int texels, int pixels, double reach_px,
                               MapBorder border) {
    // The filter takes in one pixel more to the right; another on each side is for the roundings of
    // positions, which stay below 2^-4 of a pixel for pictures of up to 2^15.
    const double pixels_per_texel = static_cast<double>(pixels) / texels;
    const double low = (first + 0.5) * pixels_per_texel - reach_px - 0.5 - 1,
                 high = (last + 0.5) * pixels_per_texel + reach_px - 0.5 + 1;
    const auto column = [&](double position) {
        return static_cast<int>(std::floor(std::clamp(position, -1.0, static_cast<double>(pixels)))) + 1;
    };
    const int before_first = 0, after_last = pixels + 2;
    const std::pair<int, int> seen = {column(low), column(high) + 1};
    const bool leaves = seen.first == before_first || seen.second == after_last;
    return leaves && border == MapBorder::wrap ? std::pair{before_first, after_last} : seen;
}

// How far from its point a sample may be seen. With e = q - p, |e| <= reach, and t = p.x / p.z, the image of
// q moves by (e.x - t e.z) / q.z, at most reach sqrt(1 + t^2) / q.z; and a sample counts only if q.z > near.
struct Reach {
    double length;  // scene units
    const AoInputs& inputs;

    Reach(const AoInputs& ao_inputs, const LunaSettings& settings)
        : length((spelt_out(settings).random_vectors == RandomVectors::raw ? kRawReach : kUnitReach) *
                 settings.radius * (1 + 1e-5)),
          inputs(ao_inputs) {}

    double in_px(int pixels, double ray_scale, double nearest_z) const {
        const double px_per_slope = 0.5 * pixels / ray_scale;
        if (!inputs.rays.perspective) return px_per_slope * length;
        const double q_z = std::max<double>(nearest_z - length, inputs.near_plane);
        return px_per_slope * length * std::sqrt(1 + ray_scale * ray_scale) / q_z;
    }
    double across_px(double nearest_z) const {
        return in_px(inputs.picture.width, inputs.rays.ray_scale.x, nearest_z);
    }
    double down_px(double nearest_z) const {
        return in_px(inputs.picture.height, inputs.rays.ray_scale.y, nearest_z);
    }

    Window window(const Window& texels, float nearest_z) const {
        const Size map = inputs.size(), picture = inputs.picture;
        const MapBorder border = inputs.fetch.border;
        const auto [left, right] =
            map_pixels(texels.left, texels.right, map.width, picture.width, across_px(nearest_z), border);
        const auto [top, bottom] =
            map_pixels(texels.top, texels.bottom, map.height, picture.height, down_px(nearest_z), border);
        return {left, top, right, bottom};
    }
};

// A view depth that no filtered depth is below, where the four filtered ones lie in `stored`; -infinity where
// there is none. With u = 2^-24 and 0 <= m <= a, b <= M, mix(a, b, t) = (a + t (b - a) (1 + 2u)) (1 + u) at
// most, each u of either sign: it falls below m by up to 2 u M + u m, which beside a far background is far
// more than the last digit of m, and rises above M by up to 3 u M. The filter mixes twice; a half more is
// allowed for what is second order. From ndc, view depth is one subtraction and one division, which rounding
// keeps monotonic where no pole lies between.
double nearest_filtered(const AoInputs& inputs, const Range& stored) {
    constexpr double kU = 1.0 / 16777216;
    const double smallest = std::fabs(stored.nearest),
                 largest = std::max<double>(smallest, std::fabs(stored.farthest));
    const double low = stored.nearest - kU * (4.5 * largest + 2.5 * smallest),
                 high = stored.farthest + kU * 6.5 * largest;
    if (inputs.fetch.depth == DepthSource::view_depth) return low;
    const float low_ndc = std::nextafter(static_cast<float>(low), -kInfiniteDepth),
                high_ndc = std::nextafter(static_cast<float>(high), kInfiniteDepth), pole = inputs.depth_a;
    const bool monotonic = !inputs.rays.perspective || low_ndc > pole || high_ndc < pole;
    return monotonic ? std::min(inputs.view_from_ndc(low_ndc), inputs.view_from_ndc(high_ndc))
                     : -kInfiniteDepth;
}

bool nothing_occludes(const LunaSettings& settings) {
    return settings.radius == 0 || settings.epsilon >= settings.fade_end;
}

// The texels of those tiles that lie wholly among the texels that show `in_map`; may be none.
Window inner_tiles(const AoInputs& inputs, const Window& in_map) {
    const auto texel = [](int map_pixel, int texels, int pixels) {
        const double at = static_cast<double>(map_pixel - 1) * texels / pixels;
        return static_cast<int>(std::clamp(at, 0.0, texels - 1.0));
    };
    const Size map = inputs.size(), picture = inputs.picture;
    constexpr int kInside = kAoTile - 1;
    return {texel(in_map.left, map.width, picture.width) + kInside,
            texel(in_map.top, map.height, picture.height) + kInside,
            texel(in_map.right, map.width, picture.width) - kInside,
            texel(in_map.bottom, map.height, picture.height) - kInside};
}

// One tile that may be open, and what decides it.
struct PerhapsOpenTile {
    int column, row;
    Window in_map;
};

}  // namespace

double sample_reach_px(const AoInputs& inputs, const LunaSettings& settings, double view_depth) {
    const Reach reach(inputs, settings);
    return std::max(reach.across_px(view_depth), reach.down_px(view_depth));
}

TileMap ao_tiles(const AoInputs& inputs, const LunaSettings& settings, const Run& run) {
    TileMap map(inputs.size(), kAoTile);
    const Size tiles = map.tiles.size;
    const auto all_rows = std::vector<char>(static_cast<std::size_t>(tiles.height), 1);
    const Image<Range> surfaces = cell_ranges(inputs.view_depth, kAoTile, all_rows, run);
    const Reach reach(inputs, settings);

    const int block_rows = (inputs.depth_map.size.height + kBlock - 1) / kBlock;
    std::vector<char> wanted(static_cast<std::size_t>(block_rows), 0);
    std::vector<PerhapsOpenTile> candidates;
    for (int row = 0; row < tiles.height; ++row) {
        for (int column = 0; column < tiles.width; ++column) {
            const Range& surface = surfaces.at(column, row);
            TileWork& work = map.tiles.at(column, row);
            if (surface.empty()) {
                if (run.leaves_out(Skip::background_pixels)) work = TileWork::background;
                continue;
            }
            if (!run.leaves_out(Skip::open_tiles)) continue;
            if (nothing_occludes(settings)) {
                work = TileWork::open;
                continue;
            }
            const auto may_be_open = [&](const Range& around) {
                return surface.farthest - around.nearest <= settings.epsilon;
            };
            // The AO map alone tells nearly all tiles that are not: first the tile, then what surrounds it.
            if (!may_be_open(surface)) continue;
            const int left = column * kAoTile, top = row * kAoTile;
            const Window in_map = reach.window({left, top, std::min(left + kAoTile, map.picture.width) - 1,
                                                std::min(top + kAoTile, map.picture.height) - 1},
                                               surface.nearest);
            if (!may_be_open(range_over(surfaces, kAoTile, inner_tiles(inputs, in_map)))) continue;
            candidates.push_back({column, row, in_map});
            for (int block = in_map.top / kBlock; block <= in_map.bottom / kBlock; ++block)
                wanted[static_cast<std::size_t>(block)] = 1;
        }
    }
    if (candidates.empty()) return map;
    const Image<Range> blocks = cell_ranges(inputs.depth_map, kBlock, wanted, run);
    for (const PerhapsOpenTile& candidate : candidates) {
        const double nearest = nearest_filtered(inputs, range_over(blocks, kBlock, candidate.in_map));
        if (surfaces.at(candidate.column, candidate.row).farthest - nearest <= settings.epsilon)
            map.tiles.at(candidate.column, candidate.row) = TileWork::open;
    }
    return map;
}

}  // namespace crevice
