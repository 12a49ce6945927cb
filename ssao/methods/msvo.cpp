#include "ssao/methods/msvo.h"

#include <string>
#include <vector>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/msvo_scales.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

// The finest scale, whose cells are the map's texels, combined with what the coarser ones leave open.
struct MsvoKernel {
    const AoInputs& inputs;
    const MsvoSettings settings;
    const DepthGrid grid;
    const MsvoBall ball;
    const std::vector<Image<float>> coarser;

    MsvoKernel(const AoInputs& ao_inputs, const MsvoSettings& msvo, const Run& run)
        : inputs(ao_inputs),
          settings(msvo),
          grid(ao_inputs, 0, msvo.seed, run),
          ball(ao_inputs, msvo, 0),
          coarser(coarser_scales(ao_inputs, msvo, run)) {}

    // The nearer point of a pair, or p where both are background.
    template <class F>
    CREVICE_INLINE SampleFacts<F> facts_of(const TexelPoint<F>& texel, const MsvoBall::Pair<F>& pair) const {
        const F per_texel = F(1 / inputs.fetch.scale);
        const Screen2<F> at{texel.at.x + F(to_float(pair.x)) * per_texel,
                            texel.at.y + F(to_float(pair.y)) * per_texel};
        const F z = select(pair.z < F(std::numeric_limits<float>::infinity()), pair.z, texel.p.z);
        const Vec3<F> r = inputs.rays.p_view(at.x / F(static_cast<float>(inputs.picture.width)),
                                             at.y / F(static_cast<float>(inputs.picture.height)), z);
        return {r, at, r, F(1), pair.share, pair.taken};
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const Int<F> x = lane_index<F>() + Int<F>(texel.x), y(texel.y);
        F sum(0);
        for (const auto& pair : ball.pairs<F>(grid, x, y, texel.p.z)) {
            witness.tell("columns", pair.x);
            witness.tell("rows", pair.y);
            witness.tell("share", pair.share);
            witness(facts_of(texel, pair));
            sum = sum + pair.taken;
        }
        for (const Image<float>& map : coarser) {
            const F open = load<F>(map.row(texel.y) + texel.x), left = max_of(F(1) - sum, F(0));
            const F taken =
                settings.combine == MsvoCombine::product ? left * (F(1) - open) : max_of(left - open, F(0));
            witness.tell("open_in_coarser_scale", open);
            witness.tell("left_open", left);
            witness(SampleFacts<F>{texel.p, texel.at, texel.p, F(1), F(1), taken});
            sum = sum + taken;
        }
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const MsvoSettings& settings, F taken) {
        return saturate(power(max_of(F(1) - taken, F(0)), F(settings.exponent)));
    }

    static std::string formula(const MsvoSettings& settings) {
        return contrast_formula("1 - sum", settings.exponent);
    }
};

}  // namespace

void validate(const MsvoSettings& s) {
    if (s.samples < kMsvoTaps || s.samples > kMsvoScales * kMsvoTaps || s.samples % kMsvoTaps != 0)
        throw UsageError("samples: must be 36, 72, 108 or 144 (" + std::to_string(s.samples) +
                         "); choose another number");
    require_within("intensity", s.intensity, 0, 4);
    require_within("thickness", s.thickness, 1, 10);
    require_common(s);
}

AoMap msvo(const AoInputs& inputs, const MsvoSettings& settings, const Run& run) {
    validate(settings);
    return each_texel(MsvoKernel(inputs, settings, run), settings, run);
}

double msvo_reach_px(const AoInputs& inputs, const MsvoSettings& settings, double view_depth) {
    // The cells that a texel is upsampled from lie within 2 texels, and within 6 of the coarsest grid; any of
    // their texels may stand for them.
    constexpr double kCells_texels = 6, kRounding_texels = 1;
    return length_px(inputs, 1.0f, view_depth) * static_cast<double>(settings.radius) +
           (kCells_texels + kRounding_texels) / static_cast<double>(inputs.fetch.scale);
}

Explanation explain_msvo(const AoInputs& inputs, const MsvoSettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(MsvoKernel(inputs, settings, {.threads = 1}), settings, x, y);
}

}  // namespace crevice
