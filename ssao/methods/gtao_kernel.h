// GTAO's kernel (see gtao.h): one text for accessibility and for bent normals.
#pragma once

#include <optional>

#include "ssao/inputs/depth_pyramid.h"
#include "ssao/methods/gtao.h"
#include "ssao/methods/settings_range.h"
#include "ssao/methods/slices.h"

namespace crevice {

static_assert(GtaoSettings{}.step_power == kStepPower);

struct GtaoKernel {
    // XeGTAO's pyramid has five levels.
    static constexpr int kCoarsestLevel = 4;
    // Of a slice's length, against a slight darkness of steep slopes (XeGTAO).
    static constexpr float kShareOfOne = 0.05f;

    const AoInputs& inputs;
    const GtaoSettings settings;
    const SlicePlan plan;
    const std::vector<glm::vec2> directions;
    const SliceNoise noise;
    const float reach, inverse_fade;  // scene units; 1 / the length over which occluders fade
    const float level_scale;          // times a distance in pixels: 2 to the power of its level, rounded down
    std::optional<DepthPyramid> pyramid;  // none where even the opposite corner is read from the picture

    GtaoKernel(const AoInputs& ao_inputs, const GtaoSettings& gtao, const Run& run)
        : inputs(ao_inputs),
          settings(gtao),
          plan(slice_plan(gtao.samples)),
          directions(slice_directions(plan.slices)),
          noise(gtao.seed, plan.slices),
          reach(gtao.radius_multiplier * gtao.radius),
          inverse_fade(inverse_or_step(gtao.falloff * reach)),
          level_scale(exp2_of(0.5f - gtao.level_offset)) {
        const float longest_px = static_cast<float>(inputs.picture.width + inputs.picture.height);
        if (longest_px * level_scale >= 2) pyramid.emplace(inputs, kCoarsestLevel, run);
    }

    // 1 / length; so large for 0 that what is nearer than the reach counts fully. With a reach of 0 nothing is.
    static float inverse_or_step(float length) {
        constexpr float kStep = 1e30f;
        return length > kSmallestRadius ? 1 / length : kStep;
    }

    // The highest sample of one side of a slice so far.
    template <class F>
    struct Horizon {
        F c;  // cosine of its angle from v; at first that of the open plane
        SampleFacts<F> highest;
    };

    // The level that is nearest to the logarithm of a distance minus the offset.
    template <class F>
    CREVICE_INLINE Int<F> level_of(F distance_px) const {
        const Int<F> log2 = (float_bits(distance_px * F(level_scale)) >> 23) - Int<F>(127);
        return clamp_int(log2, Int<F>(0), Int<F>(pyramid->top()));
    }

    // XeGTAO 1.30, XeGTAO_MainPass: falloff and thin occluder compensation. `distance` is the length of `delta`.
    template <class F>
    CREVICE_INLINE F weight_of(Vec3<F> delta, F distance, Mask<F> apart) const {
        F felt = distance;
        if (settings.thickness > 0 && settings.form != GtaoForm::paper) {
            const F deeper = delta.z * F(1 + settings.thickness);
            felt = square_root(select(apart, delta.x * delta.x + delta.y * delta.y + deeper * deeper, F(1)));
        }
        return select(apart, saturate((F(reach) - felt) * F(inverse_fade)), F(0));
    }

    // What one step found, and the names under which it is told.
    template <class F>
    struct Step {
        Screen2<F> at;  // the pixel
        F weight, c;    // how much it counts; the cosine of its angle from v, so weighed
    };
    struct StepNames {
        const char *x, *y, *weight, *c;
    };
    static constexpr StepNames kStepNames[] = {{"step_1_x", "step_1_y", "step_1_weight", "step_1_cosine"},
                                               {"step_2_x", "step_2_y", "step_2_weight", "step_2_cosine"},
                                               {"step_3_x", "step_3_y", "step_3_weight", "step_3_cosine"}};

    template <class F>
    CREVICE_INLINE Step<F> raise(Horizon<F>& horizon, const TexelPoint<F>& texel, const Slice<F>& slice,
                                 float side, F sine, F distance_px) const {
        const F along = F(side) * distance_px;
        const Screen2<F> at{texel.at.x + along * slice.x, texel.at.y + along * slice.y};
        const FetchedPixel<F> pixel =
            pyramid ? fetch_pixel(inputs, *pyramid, at, level_of(distance_px)) : fetch_pixel(inputs, at);
        const Vec3<F> delta = pixel.r - texel.p;
        const F squared = dot(delta, delta);
        const auto apart = squared > own_point_squared(texel);
        const F distance = square_root(select(apart, squared, F(1)));
        const F above_surface = dot(texel.n, delta) / distance;
        const F weight = weight_of(delta, distance, apart);
        const F c = mix(F(0) - sine, horizon_cosine(slice, side, texel.n, delta), weight);
        const Mask<F> in_front = pixel.r.z > F(inputs.near_plane), higher = (c > horizon.c) & in_front;
        if (settings.thickness > 0 && settings.form == GtaoForm::paper) {
            const F lowered = mix(horizon.c, c, F(settings.thickness));
            horizon.c = select(in_front & (c < horizon.c), lowered, horizon.c);
        }
        horizon.c = select(higher, c, horizon.c);
        horizon.highest.q = select<F>(higher, pixel.r, horizon.highest.q);
        horizon.highest.at = {select(higher, pixel.at.x, horizon.highest.at.x),
                              select(higher, pixel.at.y, horizon.highest.at.y)};
        horizon.highest.facing = select(higher, above_surface, horizon.highest.facing);
        horizon.highest.weight = select(higher, weight, horizon.highest.weight);
        return {pixel.at, weight, c};
    }

    // The horizon of one side of a slice. `side` is 1 or -1.
    template <class F, class Witness = NoWitness>
    CREVICE_INLINE Horizon<F> horizon_of(const TexelPoint<F>& texel, const Slice<F>& slice, int number,
                                         float side, F radius_px, F shift,
                                         const Witness& witness = {}) const {
        const F sine = F(side) * slice.sine;
        Horizon<F> horizon{F(0) - sine, {texel.p, texel.at, texel.p, F(0), F(0), F(0)}};
        for (int step = 0; step < plan.steps; ++step) {
            const Step<F> found =
                raise(horizon, texel, slice, side, sine,
                      step_distance_px(number, step, plan, shift, radius_px, settings.step_power));
            const StepNames& names = kStepNames[step];
            witness.tell(names.x, found.at.x);
            witness.tell(names.y, found.at.y);
            witness.tell(names.weight, found.weight);
            witness.tell(names.c, found.c);
        }
        return horizon;
    }

    // What one side of a slice loses.
    template <class F, class Witness>
    CREVICE_INLINE F lost(const TexelPoint<F>& texel, const Slice<F>& slice, int number, float side,
                          F radius_px, F shift, const Witness& witness) const {
        witness.tell("slice", Int<F>(number));
        witness.tell("side", F(side));
        witness.tell("gamma_rad", slice.gamma);
        witness.tell("length", slice.length);
        Horizon<F> horizon = horizon_of(texel, slice, number, side, radius_px, shift, witness);
        witness.tell("horizon_cosine", horizon.c);
        witness.tell("horizon_rad", arc_cosine(horizon.c));
        const F loss = counted_length(slice) *
                       closed_beyond(horizon.c, slice.cosine, F(side) * slice.sine, F(side) * slice.gamma);
        horizon.highest.r = horizon.highest.q;
        horizon.highest.contribution = loss;
        witness(horizon.highest);
        return loss;
    }

    template <class F>
    CREVICE_INLINE F counted_length(const Slice<F>& slice) const {
        return settings.form == GtaoForm::xegtao ? mix(slice.length, F(1), F(kShareOfOne)) : slice.length;
    }

    // By how much an open slice falls short of 1: nothing where losses are counted.
    template <class F, class Witness>
    CREVICE_INLINE F missing(const TexelPoint<F>& texel, const Slice<F>& slice,
                             const Witness& witness) const {
        if (settings.form == GtaoForm::losses) return F(0);
        const F missing = F(1) - counted_length(slice) * slice.open;
        witness(SampleFacts<F>{texel.p, texel.at, texel.p, F(0), F(0), missing});
        return missing;
    }

    // What XeGTAO gives back where the radius is small on the screen.
    template <class F, class Witness>
    CREVICE_INLINE F given_back(const TexelPoint<F>& texel, F radius_px, const Witness& witness) const {
        if (settings.form != GtaoForm::xegtao) return F(0);
        constexpr float kSmall_px = 10, kFades_px = 100, kMost = 0.5f;
        const F back = F(0) - F(kMost) * saturate((F(kSmall_px) - radius_px) * F(1 / kFades_px));
        witness(SampleFacts<F>{texel.p, texel.at, texel.p, F(0), F(0), back});
        return back;
    }

    // visit(slice, its number, radius in pixels, shift of the steps) for each slice of the texels.
    template <class F, class Visit>
    CREVICE_INLINE void for_each_slice(const TexelPoint<F>& texel, const Visit& visit) const {
        const F radius_px = length_px(inputs, reach, texel.p.z), shift = noise.step.at<F>(texel.x, texel.y);
        const F cosine = noise.cosine.at<F>(texel.x, texel.y), sine = noise.sine.at<F>(texel.x, texel.y);
        for (int i = 0; i < plan.slices; ++i) {
            const glm::vec2& direction = directions[static_cast<std::size_t>(i)];
            const F x = F(direction.x), y = F(direction.y);
            visit(slice_of(texel, inputs, x * cosine - y * sine, x * sine + y * cosine), i, radius_px, shift);
        }
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        witness.tell_of_texel("radius_px", length_px(inputs, reach, texel.p.z));
        F sum = given_back(texel, length_px(inputs, reach, texel.p.z), witness);
        for_each_slice(
            texel, [&](const Slice<F>& slice, int number, F radius_px, F shift)
                       __attribute__((always_inline)) {
                           sum = sum + missing(texel, slice, witness);
                           sum = sum + lost(texel, slice, number, 1, radius_px, shift, witness);
                           sum = sum + lost(texel, slice, number, -1, radius_px, shift, witness);
                       });
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const GtaoSettings& settings, F taken) {
        const F access = F(1) - taken / F(static_cast<float>(slice_plan(settings.samples).slices));
        return with_contrast(access, settings.exponent);
    }

    static std::string formula(const GtaoSettings& settings) {
        return mean_formula(slice_plan(settings.samples).slices, settings.exponent);
    }
};

}  // namespace crevice
