#include "ssao/blur/sao_blur.h"

#include <algorithm>
#include <vector>

#include "rasterizer/base/parallel.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/blur/sao_blur_kernel.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

constexpr float kNoSurface = std::numeric_limits<float>::infinity();

// A row with texels that show nothing on both sides, so that no tap needs a test of its position.
class ApronedRow {
 public:
    explicit ApronedRow(int width)
        : texels_(static_cast<std::size_t>(round_up(width, kRowAlignment) + 2 * kApron)) {}
    const float* filled(const float* row, int width, float beyond) {
        std::fill(texels_.begin(), texels_.end(), beyond);
        std::copy_n(row, width, texels_.data() + kApron);
        return texels_.data() + kApron;
    }

 private:
    static constexpr int kApron = kPublished.taps * kPublished.step;
    std::vector<float> texels_;
};

void blur_across(const SaoBlurPass& pass, const Image<float>& ao, const Image<float>& depth,
                 float inverse_depth, Image<float>& result, const Run& run) {
    const int width = ao.size.width;
    parallel_rows(ao.size.height, run, [&](int first_row, int end_row) {
        ApronedRow ao_row(width), depth_row(width);
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                const float* const values = ao_row.filled(ao.row(y), width, 1);
                const float* const depths = depth_row.filled(depth.row(y), width, kNoSurface);
                for (int x = 0; x < width; x += kLanes<F>) {
                    WeighedSum<F> at(values + x, depths + x, pass.weights[0]);
                    for (int tap = 1; tap <= pass.taps; ++tap) {
                        for (const int column : {x - tap * pass.step, x + tap * pass.step})
                            at.add(values + column, depths + column, pass.weights[tap], F(inverse_depth));
                    }
                    store(result.row(y) + x, at.mean());
                }
            }
        });
    });
}

void blur_down(const SaoBlurPass& pass, const Image<float>& ao, const Image<float>& depth,
               float inverse_depth, Image<float>& result, const Run& run) {
    const Size size = ao.size;
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < size.width; x += kLanes<F>) {
                    WeighedSum<F> at(ao.row(y) + x, depth.row(y) + x, pass.weights[0]);
                    for (int tap = 1; tap <= pass.taps; ++tap) {
                        for (const int row : {y - tap * pass.step, y + tap * pass.step}) {
                            if (row < 0 || row >= size.height) continue;
                            at.add(ao.row(row) + x, depth.row(row) + x, pass.weights[tap], F(inverse_depth));
                        }
                    }
                    store(result.row(y) + x, at.mean());
                }
            }
        });
    });
}

std::vector<Parameter<SaoBlurSettings>> sao_blur_parameters() {
    using S = SaoBlurSettings;
    return {
        choice<S, SaoBlurKind>("blur_kind", "the paper's, or the tutorials' with X_Jun's weights", &S::kind,
                               {{"sao", SaoBlurKind::sao}, {"bilateral", SaoBlurKind::bilateral}}),
        whole("blur_iterations", 0, 64, "times horizontal and vertical; 0: no blur", &S::iterations),
        yes_no("blur_quads", "first the mean of each square of four texels", &S::quads),
        yes_no("blur_fine", "at last the mean with the nearest neighbours, against stripes", &S::fine),
        number("blur_depth", "[0, inf)", kSceneUnit, "neighbours whose depth differs more do not count",
               &S::depth),
    };
}

}  // namespace

void validate(const SaoBlurSettings& s) {
    require_within("blur_iterations", s.iterations, 0, 64);
    require_length("blur_depth", s.depth);
}

AoMap sao_blur(const Image<float>& ao, const AoInputs& inputs, const SaoBlurSettings& settings,
               const Run& run) {
    validate(settings);
    if (settings.kind == SaoBlurKind::bilateral)
        return bilateral_blur(ao, inputs, bilateral_settings(settings), run);
    const float inverse_depth = inverse_limit(settings);
    AoMap blurred{ao, TileMap(ao.size, kBlurTile)};
    if (settings.iterations > 0 && settings.quads)
        even_out_quads(blurred.ao, inputs.view_depth, kQuadShare * settings.depth, run);
    Image<float> across(ao.size, 1.0f);
    const auto both_ways = [&](const SaoBlurPass& pass) {
        blur_across(pass, blurred.ao, inputs.view_depth, inverse_depth, across, run);
        blur_down(pass, across, inputs.view_depth, inverse_depth, blurred.ao, run);
    };
    for (int i = 0; i < settings.iterations; ++i) both_ways(kPublished);
    if (settings.iterations > 0 && settings.fine) both_ways(kFine);
    return blurred;
}

Denoiser sao_denoiser() {
    Denoiser denoiser;
    denoiser.defaults = AnySettings::of(SaoBlurSettings{});
    denoiser.parameters = within<AnySettings>(
        sao_blur_parameters(),
        [](auto& settings) -> auto& { return settings.template as<SaoBlurSettings>(); });
    denoiser.validate = [](const AnySettings& settings) { validate(settings.as<SaoBlurSettings>()); };
    denoiser.denoised = [](const RawAo& raw, const AnySettings& settings, const Run& run) {
        return sao_blur(raw.ao, raw.inputs, settings.as<SaoBlurSettings>(), run);
    };
    denoiser.explain = [](const RawAo& raw, const AnySettings& settings, int x, int y) {
        return explain_sao_blur(raw.ao, raw.inputs, settings.as<SaoBlurSettings>(), x, y);
    };
    return denoiser;
}

}  // namespace crevice
