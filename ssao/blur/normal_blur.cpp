#include "ssao/blur/normal_blur.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "rasterizer/base/parallel.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/methods/hemisphere_samples.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

// The map and the normals with a margin that has none, so that every tap may be read.
struct Margined {
    int margin, rounded;  // texels beyond each side; the same, rounded up to a whole group
    Image3 normal;
    Image<float> ao;

    Margined(const AoInputs& inputs, int reach)
        : margin(reach),
          rounded(round_up(reach, kRowAlignment)),
          normal(with_margin(inputs.size()), {0, 0, 0}),
          ao(with_margin(inputs.size()), 1.0f) {
        for (int y = 0; y < inputs.size().height; ++y) {
            for (int x = 0; x < inputs.size().width; ++x)
                normal.set(x + rounded, y + margin, inputs.normal.at(x, y));
        }
    }
    Size with_margin(Size size) const { return {size.width + 2 * rounded, size.height + 2 * margin}; }

    void set_ao(const Image<float>& map) {
        for (int y = 0; y < map.size.height; ++y)
            std::copy_n(map.row(y), map.size.width, ao.row(y + margin) + rounded);
    }
    template <class F>
    CREVICE_INLINE Vec3<F> normal_at(int x, int y) const {
        const std::ptrdiff_t at = x + rounded;
        return {load<F>(normal.x.row(y + margin) + at), load<F>(normal.y.row(y + margin) + at),
                load<F>(normal.z.row(y + margin) + at)};
    }
    template <class F>
    CREVICE_INLINE F ao_at(int x, int y) const {
        return load<F>(ao.row(y + margin) + x + rounded);
    }
};

// Along one direction: (1, 0) across or (0, 1) down.
struct NormalBlurPass {
    const Margined& map;
    const AoInputs& inputs;
    int step_x, step_y;         // texels from one tap to the next
    float least, inverse_rest;  // cosine from which on a tap counts; 1 / (1 - that)

    // Calls witness(column, row, cosine of the normals' angle, weight, value) for each tap, the texel itself first.
    template <class F, class Witness>
    CREVICE_INLINE F blurred(int x, int y, const Witness& witness) const {
        const Vec3<F> n = map.normal_at<F>(x, y);
        F total(kNormalBlurWeights[0]), sum = total * map.ao_at<F>(x, y);
        witness(x, y, F(1), total, map.ao_at<F>(x, y));
        for (int k = 1; k < static_cast<int>(kNormalBlurWeights.size()); ++k) {
            for (const int side : {-k, k}) {
                const int tap_x = x + side * step_x, tap_y = y + side * step_y;
                const F cosine = dot(n, map.normal_at<F>(tap_x, tap_y)), agreeing = cosine - F(least);
                const F weight = F(kNormalBlurWeights[static_cast<std::size_t>(k)]) *
                                 smooth_step(agreeing * F(inverse_rest));
                total = total + weight;
                sum = sum + weight * map.ao_at<F>(tap_x, tap_y);
                witness(tap_x, tap_y, cosine, weight, map.ao_at<F>(tap_x, tap_y));
            }
        }
        const auto surface =
            load<F>(inputs.view_depth.row(y) + x) < F(std::numeric_limits<float>::infinity());
        return select(surface, sum / total, F(1));
    }
};

struct NoTapWitness {
    template <class F>
    CREVICE_INLINE void operator()(int, int, F, F, F) const {}
};

void run_pass(const NormalBlurPass& pass, Image<float>& to, const Run& run) {
    parallel_rows(to.size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < to.size.width; x += kLanes<F>)
                    store(to.row(y) + x, pass.blurred<F>(x, y, NoTapWitness{}));
            }
        });
    });
}

}  // namespace

void validate(const NormalBlurSettings& s) {
    require_within("blur_iterations", s.iterations, 0, 64);
    require_within("blur_step", s.step, 1, 8);
    require_within("blur_normal", static_cast<double>(s.normal_threshold), 0, 1);
}

namespace {

// Calls each(pass, its iteration) for every pass over `ao`, which each() writes anew.
template <class Each>
void for_each_pass(const AoInputs& inputs, const NormalBlurSettings& settings, Image<float>& ao,
                   const Each& each) {
    const int step = settings.step;
    Margined map(inputs, step * static_cast<int>(kNormalBlurWeights.size() - 1));
    const float rest = 1 - settings.normal_threshold, inverse_rest = rest > 0 ? 1 / rest : 0;
    for (int i = 1; i <= settings.iterations; ++i) {
        for (const auto& [step_x, step_y] : {std::pair{step, 0}, std::pair{0, step}}) {
            map.set_ao(ao);
            each(NormalBlurPass{map, inputs, step_x, step_y, settings.normal_threshold, inverse_rest}, i);
        }
    }
}

ExplainedPass explained(const NormalBlurPass& pass, int x, int y) {
    ExplainedPass result;
    result.last_step = "sum / total";
    const Size size = pass.inputs.size();
    result.value =
        pass.blurred<float>(x, y, [&](int tap_x, int tap_y, float cosine, float weight, float value) {
            ExplainedTap tap{tap_x, tap_y, value, weight, "counts", {{"normal_cosine", cosine}}};
            const bool inside = tap_x >= 0 && tap_y >= 0 && tap_x < size.width && tap_y < size.height;
            if (tap_x == x && tap_y == y) {
                tap.verdict = "the texel itself";
            } else if (!inside) {
                tap.verdict = "outside the map";
            } else if (weight == 0) {
                tap.verdict = "the normals differ";
            }
            result.taps.push_back(tap);
        });
    if (!(pass.inputs.view_depth.at(x, y) < std::numeric_limits<float>::infinity())) {
        result.taps.clear();
        result.last_step = "no surface: 1";
    }
    return result;
}

std::vector<ExplainedPass> explain_normal_blur(const RawAo& raw, const NormalBlurSettings& settings, int x,
                                               int y) {
    std::vector<ExplainedPass> passes;
    Image<float> ao = raw.ao;
    for_each_pass(raw.inputs, settings, ao, [&](const NormalBlurPass& pass, int iteration) {
        passes.push_back(explained(pass, x, y));
        passes.back().name =
            "iteration " + std::to_string(iteration) + (pass.step_y == 0 ? ", across" : ", down");
        run_pass(pass, ao, {.threads = 1});
    });
    return passes;
}

}  // namespace

AoMap normal_blur(const Image<float>& ao, const AoInputs& inputs, const NormalBlurSettings& settings,
                  const Run& run) {
    validate(settings);
    AoMap blurred{ao, TileMap(ao.size, kBlurTile)};
    for_each_pass(inputs, settings, blurred.ao,
                  [&](const NormalBlurPass& pass, int) { run_pass(pass, blurred.ao, run); });
    return blurred;
}

Denoiser normal_denoiser() {
    using S = NormalBlurSettings;
    Denoiser denoiser;
    denoiser.defaults = AnySettings::of(S{});
    denoiser.parameters = within<AnySettings>(
        std::vector{
            whole("blur_iterations", 0, 64, "times horizontal and vertical; 0: no blur", &S::iterations),
            whole("blur_step", 1, 8, "texels from one tap to the next; from 2 on gaps show", &S::step),
            number("blur_normal", "[0, 1]", "cosine", "neighbours count from this agreement of normals on",
                   &S::normal_threshold)},
        [](auto& settings) -> auto& { return settings.template as<S>(); });
    denoiser.validate = [](const AnySettings& settings) { validate(settings.as<S>()); };
    denoiser.denoised = [](const RawAo& raw, const AnySettings& settings, const Run& run) {
        return normal_blur(raw.ao, raw.inputs, settings.as<S>(), run);
    };
    denoiser.explain = [](const RawAo& raw, const AnySettings& settings, int x, int y) {
        return explain_normal_blur(raw, settings.as<S>(), x, y);
    };
    return denoiser;
}

}  // namespace crevice
