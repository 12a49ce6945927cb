#include "ssao/methods/alchemy.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rasterizer/lanes/approx_math.h"
#include "ssao/inputs/noise_tile.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/obscurance.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

// Streams of the seed.
enum : std::uint32_t { kTurn, kShift, kHeight };

NoiseTile turn(std::uint32_t seed, double SineCosine::*part) {
    constexpr int kSide = 64;
    return {kSide, kSide, [=](int x, int y) {
                const auto cell = static_cast<std::uint32_t>(y * kSide + x);
                const double turns = static_cast<double>(unit_number(hash_of(seed, kTurn, cell)));
                return static_cast<float>(sine_cosine(2 * kPi * turns).*part);
            }};
}

// What one tap of all texels has in common.
struct SharedTap {
    float x, y;    // its direction before the texel's turn, unit
    float height;  // [0, 1); of a point of the sphere, before the texel's shift
};

// Each a golden angle further than the one before: whatever their number, they lie evenly around.
std::vector<SharedTap> taps_of(int samples, std::uint32_t seed) {
    constexpr double kGoldenAngle = 2.39996322972865332;
    std::vector<SharedTap> taps;
    for (int i = 0; i < samples; ++i) {
        const SineCosine at = sine_cosine(kGoldenAngle * i);
        taps.push_back({static_cast<float>(at.cosine), static_cast<float>(at.sine),
                        unit_number(hash_of(seed, kHeight, static_cast<std::uint32_t>(i)))});
    }
    return taps;
}

struct AlchemyKernel {
    const AoInputs& inputs;
    const AlchemySettings settings;
    const std::vector<SharedTap> taps;
    // Of the texel's turn; how far its taps lie into their rings, [0, 1).
    const NoiseTile cosine, sine, shift;
    const float scale, cap;  // 2 sigma, scene units; epsilon, squared scene units

    AlchemyKernel(const AoInputs& ao_inputs, const AlchemySettings& alchemy)
        : inputs(ao_inputs),
          settings(alchemy),
          taps(taps_of(alchemy.samples, alchemy.seed)),
          cosine(turn(alchemy.seed, &SineCosine::cosine)),
          sine(turn(alchemy.seed, &SineCosine::sine)),
          shift(white_noise(alchemy.seed, kShift)),
          scale(2 * alchemy.intensity * alchemy.radius),
          cap(alchemy.epsilon * alchemy.radius * alchemy.radius) {}

    // The texel's own numbers.
    template <class F>
    struct Pattern {
        F cosine, sine, shift;
        F radius_px;
    };

    // Point number i of the half ball over p, in `direction` but for its height.
    template <class F>
    CREVICE_INLINE Vec3<F> sphere_point(const TexelPoint<F>& texel, const Pattern<F>& pattern, int i,
                                        Screen2<F> direction) const {
        const F shifted = F(taps[static_cast<std::size_t>(i)].height) + pattern.shift;
        const F height = F(2) * select(shifted >= F(1), shifted - F(1), shifted) - F(1);
        const F level = square_root(max_of(F(1) - height * height, F(0)));
        const float part = static_cast<float>(i + 1) / static_cast<float>(settings.samples);
        const F length = F(settings.radius * square_root(part));
        const Vec3<F> way{level * direction.x, level * direction.y, height};
        return texel.p + select(dot(way, texel.n) < F(0), F(0) - length, length) * way;
    }

    // What the surface r takes.
    template <class F>
    CREVICE_INLINE F contribution(const TexelPoint<F>& texel, Vec3<F> v) const {
        const F above = dot(v, texel.n) - texel.p.z * F(settings.bias);
        const F squared = dot(v, v) + F(cap);
        return F(scale) * max_of(above, F(0)) / select(squared > F(0), squared, F(1));
    }

    // What is seen where a tap leads.
    template <class F>
    struct Tapped {
        FetchedPixel<F> pixel;
        Mask<F> usable;
        Vec3<F> q;  // the point of the sphere that led there; of the disk, what is seen
    };

    template <class F>
    CREVICE_INLINE Tapped<F> tapped(const TexelPoint<F>& texel, const Pattern<F>& pattern, int i) const {
        const SharedTap& base = taps[static_cast<std::size_t>(i)];
        const Screen2<F> direction{F(base.x) * pattern.cosine - F(base.y) * pattern.sine,
                                   F(base.x) * pattern.sine + F(base.y) * pattern.cosine};
        if (settings.taps == AlchemyTaps::disk) {
            const F part =
                (F(static_cast<float>(i)) + pattern.shift) / F(static_cast<float>(settings.samples));
            const F along = square_root(part) * pattern.radius_px;
            const FetchedPixel<F> pixel =
                fetch_pixel<F>(inputs, {texel.at.x + along * direction.x, texel.at.y + along * direction.y});
            return {pixel, can_occlude(inputs, pixel.r.z), pixel.r};
        }
        const Vec3<F> q = sphere_point(texel, pattern, i, direction);
        const Mask<F> visible = q.z > F(inputs.near_plane);
        const FetchedPixel<F> pixel =
            fetch_pixel(inputs, inputs.rays.p_screen(q, F(1) / select(visible, q.z, F(1))));
        const Mask<F> usable = visible & can_occlude(inputs, pixel.r.z);
        return {pixel, usable, q};
    }

    template <class F, class Witness>
    CREVICE_INLINE F tap(const TexelPoint<F>& texel, const Pattern<F>& pattern, int i,
                         const Witness& witness) const {
        const Tapped<F> found = tapped(texel, pattern, i);
        const Vec3<F> v = found.pixel.r - texel.p;
        const F distance = square_root(dot(v, v));
        const F inverse = F(1) / select(distance > F(0), distance, F(1));
        const F facing = max_of(dot(v, texel.n) * inverse, F(0));
        const F weight = select(found.usable, min_of(F(settings.radius) * inverse, F(1)), F(0));
        const F taken = select(found.usable, contribution(texel, v), F(0));
        witness.tell("height", dot(v, texel.n));
        witness.tell("bias", texel.p.z * F(settings.bias));
        witness.tell("distance", distance);
        witness(SampleFacts<F>{found.q, found.pixel.at, found.pixel.r, facing, weight, taken});
        return taken;
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const Pattern<F> pattern{cosine.at<F>(texel.x, texel.y), sine.at<F>(texel.x, texel.y),
                                 shift.at<F>(texel.x, texel.y),
                                 length_px(inputs, settings.radius, texel.p.z)};
        witness.tell_of_texel("radius_px", pattern.radius_px);
        F sum(0);
        for (int i = 0; i < settings.samples; ++i) sum = sum + tap(texel, pattern, i, witness);
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const AlchemySettings& settings, F taken) {
        const F access = F(1) - taken / F(static_cast<float>(settings.samples));
        return with_contrast(access, settings.exponent);
    }

    static std::string formula(const AlchemySettings& settings) {
        return mean_formula(settings.samples, settings.exponent);
    }
};

}  // namespace

void validate(const AlchemySettings& s) {
    require_within("samples", s.samples, 1, 64);
    require_within("intensity", s.intensity, 0, 64);
    require_within("bias", s.bias, 0, 1);
    require_within("epsilon", s.epsilon, 1e-8, 1);
    require_common(s);
}

AoMap alchemy(const AoInputs& inputs, const AlchemySettings& settings, const Run& run) {
    validate(settings);
    return each_texel(AlchemyKernel(inputs, settings), settings, run);
}

double alchemy_reach_px(const AoInputs& inputs, const AlchemySettings& settings, double view_depth) {
    const double radius = static_cast<double>(settings.radius);
    if (settings.taps == AlchemyTaps::disk || !inputs.rays.perspective)
        return reach_of_length_px(inputs, radius, view_depth);
    // Points of the ball are up to a radius nearer to the eye, and move outwards on the screen as they are.
    const double nearest = std::max(view_depth - radius, static_cast<double>(inputs.near_plane));
    const double tangent = static_cast<double>(std::max(inputs.rays.ray_scale.x, inputs.rays.ray_scale.y));
    return reach_of_length_px(inputs, radius * (1 + tangent), nearest);
}

Explanation explain_alchemy(const AoInputs& inputs, const AlchemySettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(AlchemyKernel(inputs, settings), settings, x, y);
}

}  // namespace crevice
