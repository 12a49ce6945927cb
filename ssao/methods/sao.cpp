#include "ssao/methods/sao.h"

#include <vector>

#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/obscurance.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

// A tap further away than 2^(this + 1) pixels is read from a coarser level: more, and several taps fall into
// one cell.
constexpr int kLogFinest = 3;

struct SaoKernel {
    const AoInputs& inputs;
    const SaoSettings settings;
    const SaoPlace place;
    const DepthPyramid pyramid;
    const std::vector<Screen2<float>> taps;
    const NoiseTile cosine, sine;
    const float inverse_radius;  // 0 for radius 0, where all lies at p

    SaoKernel(const AoInputs& ao_inputs, const SaoSettings& sao, const Run& run)
        : inputs(ao_inputs),
          settings(sao),
          place(sao.as_published ? SaoPlace::tapped : sao.place),
          pyramid(ao_inputs, sao.levels, run),
          taps(sao_spiral(sao)),
          cosine(sao_turn(sao, &SineCosine::cosine)),
          sine(sao_turn(sao, &SineCosine::sine)),
          inverse_radius(sao.radius > kSmallestRadius ? 1 / sao.radius : 0) {}

    // The level that a tap `distance_px` away is read from.
    template <class F>
    CREVICE_INLINE Int<F> level_of(F distance_px) const {
        const Int<F> log = (float_bits(distance_px) >> 23) - Int<F>(127);
        return clamp_int(log - Int<F>(kLogFinest), Int<F>(0), Int<F>(pyramid.top()));
    }

    template <class F>
    CREVICE_INLINE FetchedPixel<F> fetched(Screen2<F> position, F distance_px) const {
        const F width = F(static_cast<float>(inputs.picture.width)),
                height = F(static_cast<float>(inputs.picture.height));
        const auto found = pyramid.fetch(position, level_of(distance_px));
        Screen2<F> at = found.at;
        if (place == SaoPlace::tapped)
            at = {F(to_float(floor_to_int(min_of(max_of(position.x, F(-1)), width)))) + F(0.5f),
                  F(to_float(floor_to_int(min_of(max_of(position.y, F(-1)), height)))) + F(0.5f)};
        // Beyond the picture nothing can occlude.
        const F z = select(found.inside, found.z, F(inputs.depth_map.pixels.front()));
        return {at, inputs.rays.p_view(at.x / width, at.y / height, z)};
    }

    // The tap whose place on the turned spiral is `offset`, in radii; it lies `part` of a radius away.
    template <class F, class Witness>
    CREVICE_INLINE F tap(const TexelPoint<F>& texel, Screen2<F> offset, float part, F radius_px,
                         const Witness& witness) const {
        const Screen2<F> position{texel.at.x + radius_px * offset.x, texel.at.y + radius_px * offset.y};
        const FetchedPixel<F> pixel = fetched(position, F(part) * radius_px);
        const auto usable = can_occlude(inputs, pixel.r.z);
        // In radii from here on.
        const Vec3<F> v = F(inverse_radius) * (pixel.r - texel.p);
        const F squared = dot(v, v), above = dot(v, texel.n);
        const F near = max_of(F(1) - squared, F(0));
        const F weight = select(usable, near * near * near, F(0));
        const F obscurance = max_of(above - F(settings.bias), F(0)) / (F(settings.epsilon) + squared);
        const F contribution = select(weight > F(0), F(5 * settings.intensity) * weight * obscurance, F(0));
        const F distance = square_root(squared);
        const F facing = max_of(above / select(distance > F(0), distance, F(1)), F(0));
        witness.tell("level", level_of(F(part) * radius_px));
        witness.tell("height_radii", above);
        witness.tell("distance_radii", distance);
        witness(SampleFacts<F>{pixel.r, pixel.at, pixel.r, facing, weight, contribution});
        return contribution;
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const F radius_px = length_px(inputs, settings.radius, texel.p.z);
        const F c = cosine.at<F>(texel.x, texel.y), s = sine.at<F>(texel.x, texel.y);
        witness.tell_of_texel("radius_px", radius_px);
        F sum(0);
        for (int i = 0; i < settings.samples; ++i) {
            const Screen2<float> base = taps[static_cast<std::size_t>(i)];
            const float part = (static_cast<float>(i) + 0.5f) / static_cast<float>(settings.samples);
            const Screen2<F> offset{F(base.x) * c - F(base.y) * s, F(base.x) * s + F(base.y) * c};
            sum = sum + tap(texel, offset, part, radius_px, witness);
        }
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const SaoSettings& settings, F taken) {
        const F access = F(1) - taken / F(static_cast<float>(settings.samples));
        return with_contrast(access, settings.exponent);
    }

    static std::string formula(const SaoSettings& settings) {
        return mean_formula(settings.samples, settings.exponent);
    }
};

}  // namespace

void validate(const SaoSettings& s) {
    require_within("samples", s.samples, 1, 64);
    require_within("turns", s.turns, 1, 64);
    require_within("intensity", s.intensity, 0, 64);
    require_within("bias", s.bias, 0, 1);
    require_within("epsilon", s.epsilon, 1e-8, 1);
    require_within("levels", s.levels, 0, kPyramidLevels - 1);
    require_common(s);
}

std::vector<Screen2<float>> sao_spiral(const SaoSettings& settings) {
    std::vector<Screen2<float>> taps;
    for (int i = 0; i < settings.samples; ++i) {
        const double part = (i + 0.5) / settings.samples;
        const SineCosine at = sine_cosine(2 * kPi * settings.turns * part);
        taps.push_back({static_cast<float>(part * at.cosine), static_cast<float>(part * at.sine)});
    }
    return taps;
}

NoiseTile sao_turn(const SaoSettings& settings, double SineCosine::*part) {
    constexpr int kSide = 64;
    return {kSide, kSide, [=](int x, int y) {
                if (settings.as_published)
                    return static_cast<float>(sine_cosine(10.0 * ((3 * x) ^ (y + x * y))).*part);
                const auto cell = static_cast<std::uint32_t>(y * kSide + x);
                const double turns = static_cast<double>(unit_number(hash_of(settings.seed, 0, cell)));
                return static_cast<float>(sine_cosine(2 * kPi * turns).*part);
            }};
}

AoMap sao(const AoInputs& inputs, const SaoSettings& settings, const Run& run) {
    validate(settings);
    return each_texel(SaoKernel(inputs, settings, run), settings, run);
}

double sao_reach_px(const AoInputs& inputs, const SaoSettings& settings, double view_depth) {
    constexpr double kWithCell = 1.25;
    return reach_of_length_px(inputs, kWithCell * static_cast<double>(settings.radius), view_depth);
}

Explanation explain_sao(const AoInputs& inputs, const SaoSettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(SaoKernel(inputs, settings, {.threads = 1}), settings, x, y);
}

}  // namespace crevice
