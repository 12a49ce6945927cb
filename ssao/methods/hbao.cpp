#include "ssao/methods/hbao.h"

#include "rasterizer/lanes/approx_math.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/screen_rays.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

struct HbaoKernel {
    const AoInputs& inputs;
    const HbaoSettings settings;
    const std::vector<glm::vec2> directions;
    const RayNoise noise;
    const SineCosine bias;
    const float inverse_squared;  // 1 / radius^2

    HbaoKernel(const AoInputs& ao_inputs, const HbaoSettings& hbao)
        : inputs(ao_inputs),
          settings(hbao),
          directions(even_directions(hbao.samples / hbao.steps)),
          noise(hbao.seed, hbao.samples / hbao.steps),
          bias(sine_cosine(radians(static_cast<double>(hbao.bias)))),
          inverse_squared(hbao.radius * hbao.radius > 0 ? 1 / (hbao.radius * hbao.radius) : 0) {}

    // One direction over the screen: where it goes, how its tangent plane lies, and how high things stand so far.
    template <class F>
    struct ScreenRay {
        F x, y;          // on the screen, y down
        Vec3<F> v;       // the zenith
        F cosine, sine;  // of the angle from v to the normal's part in the plane of v and the direction
        F horizon;       // sine of its elevation above the plane across v
    };

    template <class F>
    CREVICE_INLINE Vec3<F> zenith(const TexelPoint<F>& texel) const {
        const F zero(0);
        const Vec3<F> axis{zero, zero, F(-1)};
        if (!inputs.rays.perspective || settings.zenith == Zenith::axis) return axis;
        return towards_eye(texel);
    }

    template <class F>
    CREVICE_INLINE ScreenRay<F> ray_along(const TexelPoint<F>& texel, Vec3<F> v, F x, F y) const {
        const F zero(0), one(1);
        const F along_v = x * v.x + y * v.y;
        const Vec3<F> t = normalize_or<F>(Vec3<F>{x, y, zero} - along_v * v, {one, zero, zero});
        const F n_t = dot(texel.n, t), n_v = max_of(dot(texel.n, v), zero);
        const F squared = n_t * n_t + n_v * n_v;
        const auto usable = squared > F(1e-12f);
        const F inverse = one / square_root(select(usable, squared, one));
        ScreenRay<F> ray{
            x, zero - y, v, select(usable, n_v * inverse, one), select(usable, n_t * inverse, zero), one};
        // The tangent has the elevation -angle; `bias` above it nothing counts, beyond the zenith there is nothing.
        const F b_cosine = F(static_cast<float>(bias.cosine)), b_sine = F(static_cast<float>(bias.sine));
        const auto below_zenith = ray.cosine * b_cosine + ray.sine * b_sine > zero;
        ray.horizon = select(below_zenith, ray.cosine * b_sine - ray.sine * b_cosine, one);
        return ray;
    }

    template <class F, class Witness>
    CREVICE_INLINE SampleFacts<F> sample(const TexelPoint<F>& texel, ScreenRay<F>& ray, Screen2<F> at,
                                         const Witness& witness) const {
        const FetchedPixel<F> pixel = fetch_pixel(inputs, at);
        const F zero(0), one(1), reach_squared = F(settings.radius) * F(settings.radius);
        const Vec3<F> delta = pixel.r - texel.p;
        const F squared = dot(delta, delta);
        const auto counts = (squared > own_point_squared(texel)) & (squared < reach_squared) &
                            (pixel.r.z > F(inputs.near_plane));
        const Vec3<F> d = (one / square_root(select(counts, squared, one))) * delta;
        const F height = cosine_beside(d, texel.n, ray.v, ray.cosine, ray.sine);
        const F weight = select(counts, saturate(one - squared * F(inverse_squared)), zero);
        const auto higher = counts & (height > ray.horizon);
        const F contribution = select(higher, weight * (height - ray.horizon), zero);
        witness.tell("sine_of_horizon", ray.horizon);
        witness.tell("sine_of_sample", height);
        ray.horizon = select(higher, height, ray.horizon);
        return {pixel.r, pixel.at, pixel.r, select(counts, dot(texel.n, d), zero), weight, contribution};
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const F radius_px = length_px(inputs, settings.radius, texel.p.z);
        const F shift = noise.shift.at<F>(texel.x, texel.y);
        const F cosine = noise.cosine.at<F>(texel.x, texel.y), sine = noise.sine.at<F>(texel.x, texel.y);
        const Vec3<F> v = zenith(texel);
        F sum(0);
        witness.tell_of_texel("radius_px", radius_px);
        int number = 0;
        for (const glm::vec2& direction : directions) {
            const F x = F(direction.x), y = F(direction.y);
            ScreenRay<F> ray = ray_along(texel, v, x * cosine - y * sine, x * sine + y * cosine);
            for (int step = 0; step < settings.steps; ++step) {
                const F along = ray_distance_px(step, settings.steps, shift, radius_px);
                witness.tell("direction", Int<F>(number));
                witness.tell("step", Int<F>(step));
                const SampleFacts<F> facts =
                    sample(texel, ray, {texel.at.x + along * ray.x, texel.at.y + along * ray.y}, witness);
                sum = sum + facts.contribution;
                witness(facts);
            }
            ++number;
        }
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const HbaoSettings& settings, F taken) {
        const F access = F(1) - taken / F(static_cast<float>(settings.samples / settings.steps));
        return with_contrast(access, settings.exponent);
    }

    static std::string formula(const HbaoSettings& settings) {
        return mean_formula(settings.samples / settings.steps, settings.exponent);
    }
};

}  // namespace

void validate(const HbaoSettings& s) {
    validate_screen_rays(s.samples, s.steps);
    require_within("bias", s.bias, 0, 89.9);
    require_common(s);
}

AoMap hbao(const AoInputs& inputs, const HbaoSettings& settings, const Run& run) {
    validate(settings);
    return each_texel(HbaoKernel(inputs, settings), settings, run);
}

double hbao_reach_px(const AoInputs& inputs, const HbaoSettings& settings, double view_depth) {
    return reach_of_length_px(inputs, static_cast<double>(settings.radius), view_depth);
}

Explanation explain_hbao(const AoInputs& inputs, const HbaoSettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(HbaoKernel(inputs, settings), settings, x, y);
}

}  // namespace crevice
