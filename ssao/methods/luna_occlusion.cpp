#include "ssao/methods/luna_occlusion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "ssao/methods/open_tiles.h"

namespace crevice {

void validate(const LunaSettings& s) {
    const auto require = [](bool holds, const std::string& name, double value, const std::string& range) {
        if (!holds)
            throw UsageError(name + ": must lie in " + range + " (" +
                             shortest_text(static_cast<float>(value)) + "); choose another value");
    };
    const auto length = [](float a) { return a >= 0 && std::isfinite(a); };
    require(s.samples >= 1 && s.samples <= kCubeVectors, "samples", s.samples, "1..14");
    require(length(s.radius), "radius", s.radius, "[0, inf)");
    require(length(s.fade_start), "fade_start", s.fade_start, "[0, inf)");
    require(std::isfinite(s.fade_end) && s.fade_end >= s.fade_start, "fade_end", s.fade_end,
            "[fade_start, inf)");
    require(length(s.epsilon), "epsilon", s.epsilon, "[0, inf)");
    require(s.exponent >= 0 && s.exponent <= 64, "exponent", s.exponent, "[0, 64]");
    ao_map_size({1, 1}, s.ao_scale);  // which refuses what is no scale
}

LunaSettings spelt_out(LunaSettings settings) {
    if (!settings.as_published) return settings;
    if (settings.random_vectors == RandomVectors::unit) settings.random_vectors = RandomVectors::raw;
    settings.sign_of_zero = SignOfZero::zero;
    settings.edge_texels = EdgeTexels::mixed;
    settings.sky_depth = SkyDepth::as_stored;
    return settings;
}

bool shows_artifacts(const LunaSettings& settings) {
    return settings.as_published || settings.random_vectors != RandomVectors::unit ||
           settings.sign_of_zero != SignOfZero::plus || !settings.self_occlusion_test ||
           settings.border != MapBorder::far || settings.texel_centre != TexelCentre::exact ||
           settings.edge_texels != EdgeTexels::nearest || settings.sky_depth != SkyDepth::finite;
}

AoFetch ao_fetch(const LunaSettings& settings, bool point_normals) {
    const LunaSettings s = spelt_out(settings);
    return {s.depth_source, point_normals, s.ao_scale, s.edge_texels, s.sky_depth, s.border, s.texel_centre};
}

namespace {

// The contrast of a row of accessibilities. After the samples and not with them: a power is one long chain of operations
// that wait for each other, and here the processor overlaps those of neighbours.
template <class F>
CREVICE_INLINE void store_contrast(const LunaKernel& kernel, float* row, int count) {
    for (int x = 0; x < count; x += kLanes<F>) {
        const F access = load<F>(row + x);
        if (!all(access == F(1))) store(row + x, kernel.stored(access));
    }
}

}  // namespace

AoMap luna_occlusion(const AoInputs& inputs, const LunaSettings& settings, const Run& run) {
    validate(settings);
    AoMap map{Image<float>(inputs.size(), 1.0f), ao_tiles(inputs, settings, run)};
    Image<float>& ao = map.ao;
    const TileMap& tiles = map.tiles;
    if (tiles.count(TileWork::done) == 0) return map;
    const LunaKernel kernel(inputs, settings);
    const RandomMap random = random_map(settings.seed, run);
    const WholeDepthMap depths{inputs.depth_map};
    const bool skip_background = run.leaves_out(Skip::background_pixels);
    parallel_rows(ao.size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < ao.size.width; x += kLanes<F>) {
                    if (tiles.tiles.at(x / kAoTile, y / kAoTile) != TileWork::done) continue;
                    const F z = load<F>(inputs.view_depth.row(y) + x);
                    if (skip_background && !any(z < F(std::numeric_limits<float>::infinity()))) continue;
                    store(ao.row(y) + x, kernel.accessibility_at<F>(random, x, y, depths));
                }
                store_contrast<F>(kernel, ao.row(y), ao.size.width);
            }
        });
    });
    return map;
}

Image<float> luna_occlusion_in_double(const AoInputs& inputs, const LunaSettings& settings, const Run& run) {
    validate(settings);
    Image<float> ao(inputs.size(), 1.0f);
    const LunaKernel kernel(inputs, settings);
    const RandomMap map = random_map(settings.seed, run);
    parallel_rows(ao.size.height, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            for (int x = 0; x < ao.size.width; ++x) {
                const LunaPoint<double> at = kernel.point_at<double>(map, x, y);
                if (!at.surface) continue;
                const double access = kernel.accessibility(at.p, at.n, at.random);
                const double contrast =
                    std::pow(std::max(access, 0.0), static_cast<double>(settings.exponent));
                ao.at(x, y) = stored_as(static_cast<float>(std::min(contrast, 1.0)), settings.format);
            }
        }
    });
    return ao;
}

}  // namespace crevice
