#include "rasterizer/draw/precision_counts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "rasterizer/base/parallel_results.h"

namespace crevice {

namespace {

constexpr float kBackgroundDepth = std::numeric_limits<float>::infinity();

// What a thread takes at once.
constexpr std::size_t kRowsAtOnce = 32, kVerticesAtOnce = 1 << 15;

std::size_t sum_of(const std::vector<std::size_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

template <class F>
CREVICE_INLINE std::size_t sum_of_lanes(Int<F> counts) {
    std::int32_t each[kLanes<F>];
    store(each, counts);
    return static_cast<std::size_t>(std::accumulate(each, each + kLanes<F>, 0));
}

// Pixels of a picture for which is_counted, a kernel, gives true; it is asked of kLanes<F> from (x, y) on.
template <class IsCounted>
std::size_t counted_pixels(Size size, const Run& run, const IsCounted& is_counted) {
    return sum_of(parallel_results<std::size_t>(
        static_cast<std::size_t>(size.height), kRowsAtOnce, run, [&](std::size_t first, std::size_t end) {
            std::size_t sum = 0;
            run_kernel(run, [&]<class F>(Lanes<F> lanes) {
                Int<F> counts(0);
                for (auto y = static_cast<int>(first); y < static_cast<int>(end); ++y) {
                    for (int x = 0; x < size.width; x += kLanes<F>) {
                        const Mask<F> inside = lane_index<F>() < Int<F>(size.width - x),
                                      counted = is_counted(lanes, x, y);
                        counts = counts + select(inside & counted, Int<F>(1), Int<F>(0));
                    }
                }
                sum = sum_of_lanes<F>(counts);
            });
            return sum;
        }));
}

// The largest float that is no larger than `value`: a float is larger than the one if it is larger than the other.
float float_at_most(double value) {
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) > value
               ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
               : nearest;
}

}  // namespace

float farthest_depth(const Image<float>& view_depth, const Run& run) {
    const Size size = view_depth.size;
    const std::vector<float> farthest = parallel_results<float>(
        static_cast<std::size_t>(size.height), kRowsAtOnce, run, [&](std::size_t first, std::size_t end) {
            float largest = 0;
            run_kernel(run, [&]<class F>(Lanes<F>) {
                F found(0);
                for (auto y = static_cast<int>(first); y < static_cast<int>(end); ++y) {
                    const float* const row = view_depth.row(y);
                    for (int x = 0; x < size.width; x += kLanes<F>) {
                        const F depth = load<F>(row + x);
                        const Mask<F> inside = lane_index<F>() < Int<F>(size.width - x);
                        found = max_of(select(inside & (depth < F(kBackgroundDepth)), depth, F(0)), found);
                    }
                }
                float each[kLanes<F>];
                store(each, found);
                largest = *std::max_element(each, each + kLanes<F>);
            });
            return largest;
        });
    return farthest.empty() ? 0 : *std::max_element(farthest.begin(), farthest.end());
}

std::size_t pixels_beyond(const Image<float>& view_depth, double depth, const Run& run) {
    const float limit = float_at_most(depth);
    return counted_pixels(view_depth.size, run, [&]<class F>(Lanes<F>, int x, int y) {
        const F here = load<F>(view_depth.row(y) + x);
        return (here < F(kBackgroundDepth)) & (here > F(limit));
    });
}

std::size_t pixels_seen_only_in(const Image<std::int32_t>& second, const Image<std::int32_t>& first,
                                const Run& run) {
    return counted_pixels(first.size, run, [&]<class F>(Lanes<F>, int x, int y) {
        using I = Int<F>;
        const I before = load<F>(first.row(y) + x), after = load<F>(second.row(y) + x);
        return (before == I(kNoTriangle)) & (after != I(kNoTriangle));
    });
}

bool shows_a_triangle(const ScreenGeometry& geometry, const GBuffer& gbuffer) {
    for (int tile = 0; tile < geometry.tile_count(); ++tile) {
        if (gbuffer.tiles[static_cast<std::size_t>(tile)].triangles == 0) continue;
        const PixelRect part = geometry.tile_rect(tile);
        for (int y = part.y0; y < part.y1; ++y) {
            const std::int32_t* const row = gbuffer.triangle.row(y);
            const auto shown = [](std::int32_t triangle) { return triangle != kNoTriangle; };
            if (std::any_of(row + part.x0, row + part.x1, shown)) return true;
        }
    }
    return false;
}

std::int32_t farthest_code(const ScreenGeometry& geometry, DepthFormat format, bool reversed_z) {
    double farthest = reversed_z ? 1 : 0;
    for (const TriangleBlock& block : geometry.blocks)
        farthest = reversed_z ? std::min(farthest, block.z_lowest) : std::max(farthest, block.z_highest);
    return depth_code(format, 0.0f, farthest);
}

std::size_t vertices_not_finite(const ScreenGeometry& geometry, const Run& run) {
    const VertexArray<std::int32_t>& outside = geometry.vertices.projected.outside;
    return sum_of(parallel_results<std::size_t>(
        outside.size(), kVerticesAtOnce, run, [&](std::size_t first, std::size_t end) {
            std::size_t sum = 0;
            run_kernel(run, [&]<class F>(Lanes<F>) {
                Int<F> counts(0);
                std::size_t i = first;
                for (; i + kLanes<F> <= end; i += kLanes<F>) {
                    const Int<F> not_finite = load<F>(outside.data() + i) & Int<F>(kNotANumber);
                    counts = counts + select(not_finite != Int<F>(0), Int<F>(1), Int<F>(0));
                }
                sum = sum_of_lanes<F>(counts);
                for (; i < end; ++i) sum += (outside[i] & kNotANumber) != 0 ? 1 : 0;
            });
            return sum;
        }));
}

std::size_t triangles_through_eye_plane(const ScreenGeometry& geometry) {
    std::size_t count = 0;
    const PixelRect picture = {0, 0, geometry.size.width, geometry.size.height};
    const auto behind = [&](std::uint32_t vertex) {
        return (geometry.vertices.projected.outside[vertex] & kOutsideEye) != 0;
    };
    for (const TriangleBlock& block : geometry.blocks) {
        if (block.clipped.empty()) continue;
        const ScreenTriangle* counted = nullptr;  // pieces of one triangle follow one another
        for (const ScreenTriangle& t : block.triangles) {
            const bool piece_of_counted = counted != nullptr && counted->vertex == t.vertex;
            if (t.clipped < 0 || piece_of_counted || common_part(t.bounds, picture).empty()) continue;
            if (std::none_of(t.vertex.begin(), t.vertex.end(), behind)) continue;
            counted = &t;
            ++count;
        }
    }
    return count;
}

}  // namespace crevice
