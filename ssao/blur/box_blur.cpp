#include "ssao/blur/box_blur.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "rasterizer/base/parallel.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

constexpr int kReach = 2;  // texels to each side
// Weights of the taps from -2 to 2: powers of two, so that a mean of ones is exactly 1.
using BoxWeights = std::array<float, 2 * kReach + 1>;
constexpr BoxWeights kShifted = {0.25f, 0.25f, 0.25f, 0.25f, 0},
                     kCentred = {0.125f, 0.25f, 0.25f, 0.25f, 0.125f};

// The taps of `weights` as row_of_tap(k) gives them, k from 0 to 4, of the texels from x on.
template <class F, class RowOfTap>
CREVICE_INLINE F weighted_sum(const BoxWeights& weights, const RowOfTap& row_of_tap, int x) {
    F sum(0);
    for (int k = 0; k <= 2 * kReach; ++k)
        sum = sum + F(weights[static_cast<std::size_t>(k)]) * load<F>(row_of_tap(k) + x);
    return sum;
}

void blur_across(const Image<float>& from, const BoxWeights& weights, Image<float>& to, const Run& run) {
    parallel_rows(from.size.height, run, [&](int first_row, int end_row) {
        // A row with its outermost texels repeated, as far as the last group reads.
        std::vector<float> wide(static_cast<std::size_t>(from.stride + 2 * kReach));
        for (int y = first_row; y < end_row; ++y) {
            const float* const row = from.row(y);
            std::fill_n(wide.begin(), kReach, row[0]);
            std::copy_n(row, from.size.width, wide.begin() + kReach);
            std::fill(wide.begin() + kReach + from.size.width, wide.end(), row[from.size.width - 1]);
            run_kernel(run, [&]<class F>(Lanes<F>) {
                const auto row_of_tap = [&](int k) __attribute__((always_inline)) { return wide.data() + k; };
                for (int x = 0; x < from.size.width; x += kLanes<F>)
                    store(to.row(y) + x, weighted_sum<F>(weights, row_of_tap, x));
            });
        }
    });
}

void blur_down(const Image<float>& from, const Image<float>& view_depth, const BoxWeights& weights,
               Image<float>& to, const Run& run) {
    parallel_rows(from.size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                const auto row_of_tap = [&](int k) __attribute__((always_inline)) {
                    return from.row(std::clamp(y + k - kReach, 0, from.size.height - 1));
                };
                for (int x = 0; x < from.size.width; x += kLanes<F>) {
                    const auto surface =
                        load<F>(view_depth.row(y) + x) < F(std::numeric_limits<float>::infinity());
                    store(to.row(y) + x, select(surface, weighted_sum<F>(weights, row_of_tap, x), F(1)));
                }
            }
        });
    });
}

// Along one direction, (1, 0) or (0, 1): as blur_across() and blur_down() do it.
ExplainedPass explained_pass(const Image<float>& map, const AoInputs& inputs, const BoxWeights& weights,
                             int x, int y, int along_x, int along_y) {
    ExplainedPass pass;
    pass.last_step = "sum / total";
    float values[2 * kReach + 1][1];
    for (int k = 0; k <= 2 * kReach; ++k) {
        ExplainedTap tap;
        tap.x = std::clamp(x + along_x * (k - kReach), 0, map.size.width - 1);
        tap.y = std::clamp(y + along_y * (k - kReach), 0, map.size.height - 1);
        tap.value = values[k][0] = map.at(tap.x, tap.y);
        tap.weight = weights[static_cast<std::size_t>(k)];
        tap.verdict = tap.weight > 0 ? "counts" : "outside the box";
        pass.taps.push_back(tap);
    }
    pass.value = weighted_sum<float>(
        weights, [&](int k) { return values[k]; }, 0);
    if (along_y == 1 && !(inputs.view_depth.at(x, y) < std::numeric_limits<float>::infinity())) {
        pass.taps.clear();
        pass.last_step = "no surface: 1";
        pass.value = 1;
    }
    return pass;
}

std::vector<ExplainedPass> explain_box_blur(const RawAo& raw, const BoxBlurSettings& settings, int x, int y) {
    const BoxWeights& weights = settings.shift ? kShifted : kCentred;
    std::vector<ExplainedPass> passes;
    Image<float> map = raw.ao, across(raw.ao.size);
    for (int i = 1; i <= settings.iterations; ++i) {
        blur_across(map, weights, across, {.threads = 1});
        passes.push_back(explained_pass(map, raw.inputs, weights, x, y, 1, 0));
        passes.back().name = "iteration " + std::to_string(i) + ", across";
        passes.push_back(explained_pass(across, raw.inputs, weights, x, y, 0, 1));
        passes.back().name = "iteration " + std::to_string(i) + ", down";
        blur_down(across, raw.inputs.view_depth, weights, map, {.threads = 1});
    }
    return passes;
}

std::vector<Parameter<BoxDenoiserSettings>> box_parameters() {
    using S = BoxDenoiserSettings;
    const auto of_box = [](auto& settings) -> auto& { return settings.box; };
    const auto of_bilateral = [](auto& settings) -> auto& { return settings.bilateral; };
    std::vector<Parameter<S>> all = {
        choice<S, BlurKind>("blur_kind", "the source's box, or the bilateral one, which stops at edges",
                            &S::kind, {{"box", BlurKind::box}, {"bilateral", BlurKind::bilateral}})};
    for (Parameter<S>& p : within<S>(
             std::vector{whole("blur_iterations", 0, 64, "0: no blur", &BoxBlurSettings::iterations),
                         yes_no("blur_shift", "true: the source's box, which moves the map half a texel",
                                &BoxBlurSettings::shift)},
             of_box))
        all.push_back(std::move(p));
    for (Parameter<S>& p :
         within<S>(std::vector{number("blur_normal", "[-1, 1]", "cosine",
                                      "bilateral: neighbours whose normals agree less do not count",
                                      &BlurSettings::normal_threshold),
                               number("blur_depth", "[0, inf)", kSceneUnit,
                                      "bilateral: neighbours whose depth differs more do not count",
                                      &BlurSettings::depth_threshold)},
                   of_bilateral))
        all.push_back(std::move(p));
    return all;
}

// Of BlurKind::bilateral.
BlurSettings bilateral_of(const BoxDenoiserSettings& settings, const RawAo& raw) {
    BlurSettings bilateral = settings.bilateral;
    bilateral.iterations = settings.box.iterations;
    bilateral.format = raw.format;
    return bilateral;
}

}  // namespace

void validate(const BoxBlurSettings& s) { require_within("blur_iterations", s.iterations, 0, 64); }

AoMap box_blur(const Image<float>& ao, const AoInputs& inputs, const BoxBlurSettings& settings,
               const Run& run) {
    validate(settings);
    AoMap blurred{ao, TileMap(ao.size, kBlurTile)};
    const BoxWeights& weights = settings.shift ? kShifted : kCentred;
    Image<float> across(ao.size);
    for (int i = 0; i < settings.iterations; ++i) {
        blur_across(blurred.ao, weights, across, run);
        blur_down(across, inputs.view_depth, weights, blurred.ao, run);
    }
    return blurred;
}

Denoiser box_denoiser() {
    using S = BoxDenoiserSettings;
    Denoiser denoiser;
    denoiser.defaults = AnySettings::of(S{});
    denoiser.parameters = within<AnySettings>(
        box_parameters(), [](auto& settings) -> auto& { return settings.template as<S>(); });
    denoiser.validate = [](const AnySettings& settings) {
        validate(settings.as<S>().box);
        validate(settings.as<S>().bilateral);
    };
    denoiser.denoised = [](const RawAo& raw, const AnySettings& settings, const Run& run) {
        const S& s = settings.as<S>();
        if (s.kind == BlurKind::box) return box_blur(raw.ao, raw.inputs, s.box, run);
        return bilateral_blur(raw.ao, raw.inputs, bilateral_of(s, raw), run);
    };
    denoiser.explain = [](const RawAo& raw, const AnySettings& settings, int x, int y) {
        const S& s = settings.as<S>();
        if (s.kind == BlurKind::box) return explain_box_blur(raw, s.box, x, y);
        return explain_bilateral_blur(raw.ao, raw.inputs, bilateral_of(s, raw), x, y);
    };
    return denoiser;
}

}  // namespace crevice
