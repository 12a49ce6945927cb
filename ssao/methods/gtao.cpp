#include "ssao/methods/gtao.h"

#include <algorithm>
#include <cmath>

#include "ssao/methods/settings_range.h"
#include "ssao/methods/slices.h"

namespace crevice {

namespace {

struct GtaoKernel {
    const AoInputs& inputs;
    const GtaoSettings settings;
    const SlicePlan plan;
    const std::vector<glm::vec2> directions;
    const SliceNoise noise;
    const float reach, inverse_fade;  // scene units; 1 / the length over which occluders fade

    GtaoKernel(const AoInputs& ao_inputs, const GtaoSettings& gtao)
        : inputs(ao_inputs),
          settings(gtao),
          plan(slice_plan(gtao.samples)),
          directions(slice_directions(plan.slices)),
          noise(gtao.seed, plan.slices),
          reach(kGtaoReach * gtao.radius),
          inverse_fade(reach > 0 ? 1 / (kGtaoFade * reach) : 0) {}

    // The highest sample of one side of a slice so far.
    template <class F>
    struct Horizon {
        F c;  // cosine of its angle from v; at first that of the open plane
        SampleFacts<F> highest;
    };

    // XeGTAO 1.30, XeGTAO_MainPass: falloff, thin occluder compensation, horizon.
    template <class F>
    CREVICE_INLINE void raise(Horizon<F>& horizon, const TexelPoint<F>& texel, const Slice<F>& slice,
                              float side, F sine, Screen2<F> at) const {
        const FetchedPixel<F> pixel = fetch_pixel(inputs, at);
        const Vec3<F> delta = pixel.r - texel.p;
        const F squared = dot(delta, delta);
        const auto apart = squared > own_point_squared(texel);
        const F distance = square_root(select(apart, squared, F(1)));
        const F above_surface = dot(texel.n, delta) / distance;
        const F deeper = delta.z * F(1 + settings.thickness);
        const F felt =
            settings.thickness == 0
                ? distance
                : square_root(select(apart, delta.x * delta.x + delta.y * delta.y + deeper * deeper, F(1)));
        const F weight = select(apart, saturate((F(reach) - felt) * F(inverse_fade)), F(0));
        const F c = mix(F(0) - sine, horizon_cosine(slice, side, texel.n, delta), weight);
        const auto higher = (c > horizon.c) & (pixel.r.z > F(inputs.near_plane));
        horizon.c = select(higher, c, horizon.c);
        horizon.highest.q = select<F>(higher, pixel.r, horizon.highest.q);
        horizon.highest.at = {select(higher, pixel.at.x, horizon.highest.at.x),
                              select(higher, pixel.at.y, horizon.highest.at.y)};
        horizon.highest.facing = select(higher, above_surface, horizon.highest.facing);
        horizon.highest.weight = select(higher, weight, horizon.highest.weight);
    }

    // What one side of a slice loses. `side` is 1 or -1.
    template <class F, class Witness>
    CREVICE_INLINE F lost(const TexelPoint<F>& texel, const Slice<F>& slice, int number, float side,
                          F radius_px, F shift, const Witness& witness) const {
        const F sine = F(side) * slice.sine, gamma = F(side) * slice.gamma;
        Horizon<F> horizon{F(0) - sine, {texel.p, texel.at, texel.p, F(0), F(0), F(0)}};
        for (int step = 0; step < plan.steps; ++step) {
            const F along = F(side) * step_distance_px(number, step, plan, shift, radius_px);
            raise(horizon, texel, slice, side, sine,
                  {texel.at.x + along * slice.x, texel.at.y + along * slice.y});
        }
        const F loss = slice.length * closed_beyond(horizon.c, slice.cosine, sine, gamma);
        horizon.highest.r = horizon.highest.q;
        horizon.highest.contribution = loss;
        witness(horizon.highest);
        return loss;
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const F radius_px = length_px(inputs, reach, texel.p.z), shift = noise.step.at<F>(texel.x, texel.y);
        const F cosine = noise.cosine.at<F>(texel.x, texel.y), sine = noise.sine.at<F>(texel.x, texel.y);
        F sum(0);
        for (int i = 0; i < plan.slices; ++i) {
            const glm::vec2& direction = directions[static_cast<std::size_t>(i)];
            const F x = F(direction.x), y = F(direction.y);
            const Slice<F> slice = slice_of(texel, inputs, x * cosine - y * sine, x * sine + y * cosine);
            sum = sum + lost(texel, slice, i, 1, radius_px, shift, witness);
            sum = sum + lost(texel, slice, i, -1, radius_px, shift, witness);
        }
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const GtaoSettings& settings, F taken) {
        const F access = F(1) - taken / F(static_cast<float>(slice_plan(settings.samples).slices));
        return with_contrast(access, settings.exponent);
    }
};

}  // namespace

void validate(const GtaoSettings& s) {
    validate_slice_samples(s.samples);
    require_radius(s.radius);
    require_within("thickness", s.thickness, 0, 0.7);
    require_within("exponent", s.exponent, 0, 64);
    ao_map_size({1, 1}, s.ao_scale);  // which refuses what is no scale
}

AoMap gtao(const AoInputs& inputs, const GtaoSettings& settings, const Run& run) {
    validate(settings);
    return each_texel(GtaoKernel(inputs, settings), settings, run);
}

double gtao_reach_px(const AoInputs& inputs, const GtaoSettings& settings, double view_depth) {
    const double length = static_cast<double>(kGtaoReach) * static_cast<double>(settings.radius);
    constexpr double kNextPixel = 2;
    return length_px(inputs, 1.0f, view_depth) * length + kNextPixel;
}

Explanation explain_gtao(const AoInputs& inputs, const GtaoSettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(GtaoKernel(inputs, settings), settings, x, y);
}

}  // namespace crevice
