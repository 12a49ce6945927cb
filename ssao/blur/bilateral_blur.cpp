#include "ssao/blur/bilateral_blur.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "ssao/blur/blur_band.h"

namespace crevice {

namespace {

// More are done in a further sweep: what a band computes of its neighbours' rows grows with each.
constexpr int kIterationsPerSweep = 8;

// The first rows of the bands, and the end of the last: a band a thread, because each computes rows of its
// neighbours as well, with about the same work in each, judged by one texel in 64. Changes no bit.
std::vector<int> band_limits(const BlurSweep& sweep, int bands) {
    constexpr int kStep = 8;
    constexpr int kBlurredOverCopied = 2;  // how many texels are copied in the time that one is blurred
    const Size size = sweep.size();
    std::vector<int> work_above = {0};  // of the sampled rows
    for (int y = 0; y < size.height; y += kStep) {
        int work = 0;
        for (int x = 0; x < size.width; x += kStep) {
            const bool blurred = sweep.inputs.view_depth.at(x, y) < kNoSurface && !sweep.is_open(x, y);
            work += blurred ? kBlurredOverCopied : 1;
        }
        work_above.push_back(work_above.back() + work);
    }
    std::vector<int> limits;
    for (int band = 0; band < bands; ++band) {
        const std::int64_t above = std::int64_t{work_above.back()} * band / bands;
        const auto row = std::lower_bound(work_above.begin(), work_above.end(), above);
        limits.push_back(std::min(size.height, kStep * static_cast<int>(row - work_above.begin())));
    }
    limits.push_back(size.height);
    return limits;
}

Image<float> swept(const BlurSweep& sweep, const Run& run) {
    Image<float> result(sweep.size());
    const int bands = thread_count(run);
    const std::vector<int> limits = band_limits(sweep, bands);
    parallel_for(bands, run, [&](int i) {
        const Rows own = {limits[static_cast<std::size_t>(i)], limits[static_cast<std::size_t>(i) + 1]};
        if (own.first == own.end) return;
        BlurBand band(sweep);
        run_kernel(run, [&]<class F>(Lanes<F>) { band.sweep_down<F>(own, result); });
    });
    return result;
}

}  // namespace

void validate(const BlurSettings& s) {
    const auto require = [](bool holds, const std::string& name, double value, const std::string& range) {
        if (!holds)
            throw UsageError(name + ": must lie in " + range + " (" +
                             shortest_text(static_cast<float>(value)) + "); choose another value");
    };
    require(s.iterations >= 0 && s.iterations <= 64, "blur_iterations", s.iterations, "0..64");
    require(s.normal_threshold >= -1 && s.normal_threshold <= 1, "blur_normal", s.normal_threshold,
            "[-1, 1]");
    require(s.depth_threshold >= 0 && std::isfinite(s.depth_threshold), "blur_depth", s.depth_threshold,
            "[0, inf)");
    for (const float w : s.weights) require(w > 0 && std::isfinite(w), "blur weights", w, "(0, inf)");
    const float total = std::accumulate(s.weights.begin(), s.weights.end(), 0.0f);
    require(std::isfinite(total), "sum of the blur weights", total, "(0, inf)");
}

AoMap bilateral_blur(const Image<float>& ao, const AoInputs& inputs, const BlurSettings& settings,
                     const Run& run) {
    validate(settings);
    AoMap blurred{{}, TileMap(ao.size, kBlurTile)};
    if (run.leaves_out(Skip::open_tiles)) blurred.tiles = open_blur_tiles(ao, settings, run);
    if (settings.iterations == 0) {
        blurred.ao = ao;
        return blurred;
    }
    const bool some_open = blurred.tiles.count(TileWork::open) > 0;
    const TileMap no_tiles;  // spares the test of each tile
    const BlurRays rays(inputs, settings.edges);
    for (int done = 0; done < settings.iterations; done += kIterationsPerSweep) {
        const BlurSweep sweep{.ao = done == 0 ? ao : blurred.ao,
                              .inputs = inputs,
                              .rays = rays,
                              .settings = settings,
                              .iterations = std::min(kIterationsPerSweep, settings.iterations - done),
                              .open_tiles = some_open ? blurred.tiles : no_tiles,
                              .skips_background = run.leaves_out(Skip::background_pixels)};
        blurred.ao = swept(sweep, run);
    }
    return blurred;
}

}  // namespace crevice
