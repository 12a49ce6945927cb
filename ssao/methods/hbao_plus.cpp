#include "ssao/methods/hbao_plus.h"

#include "rasterizer/base/float_text.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/screen_rays.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

// The listing's 0.01 over the square of the radius that goes with it.
constexpr float kClampedSquare = 0.01f / (0.8f * 0.8f);

// The listing turns by up to a third of the circle, however many directions there are.
constexpr int kListedTurns = 3;

std::vector<glm::vec2> directions_of(const HbaoPlusSettings& s) {
    const int count = s.samples / s.steps;
    if (s.table == RayTable::even) return even_directions(count);
    std::vector<glm::vec2> listed = even_directions(3);
    listed.resize(static_cast<std::size_t>(count), {0, 1});
    return listed;
}

// A number as an 8-bit texture holds it.
template <class F>
CREVICE_INLINE F as_unorm8(F a) {
    return F(to_float(floor_to_int(saturate(a) * F(255) + F(0.5f)))) / F(255);
}

float aspect(const AoInputs& inputs) {
    return static_cast<float>(inputs.picture.width) / static_cast<float>(inputs.picture.height);
}

// By how much rays are longer than the radius looks.
float stretch(const AoInputs& inputs, const HbaoPlusSettings& s) {
    return spelt_out(s).projected_by == ProjectedBy::width ? aspect(inputs) : 1.0f;
}

// The shorter one of the ways to a pixel from its two neighbours of one row or column.
template <class F>
CREVICE_INLINE Vec3<F> shorter(Vec3<F> a, Vec3<F> b) {
    return select<F>(dot(a, a) < dot(b, b), a, b);
}

// The normal of the pixel under the texel's centre, towards the eye; no normal where its neighbours show none.
template <class F>
CREVICE_INLINE Vec3<F> normal_from_depth(const AoInputs& inputs, const TexelPoint<F>& texel) {
    const FetchedPixel<F> pixel = fetch_pixel(inputs, texel.at);
    const auto seen_at = [&](float right, float down) __attribute__((always_inline)) {
        return fetch_pixel<F>(inputs, {pixel.at.x + F(right), pixel.at.y + F(down)}).r;
    };
    const Vec3<F> right = shorter<F>(seen_at(1, 0) - pixel.r, pixel.r - seen_at(-1, 0)),
                  down = shorter<F>(seen_at(0, 1) - pixel.r, pixel.r - seen_at(0, -1));
    return normalize_any_length<F>(cross(right, down));
}

struct HbaoPlusKernel {
    const AoInputs& inputs;
    const HbaoPlusSettings settings;  // spelt out
    const std::vector<glm::vec2> directions;
    const RayNoise noise;
    const float ray_length;       // scene units
    const float least_squared;    // to which shorter squares are raised
    const float inverse_squared;  // 1 / radius^2

    HbaoPlusKernel(const AoInputs& ao_inputs, const HbaoPlusSettings& hbao_plus)
        : inputs(ao_inputs),
          settings(spelt_out(hbao_plus)),
          directions(directions_of(settings)),
          noise(settings.seed,
                settings.turns == TurnFormat::unorm8 ? kListedTurns : settings.samples / settings.steps),
          ray_length(settings.radius * stretch(inputs, settings)),
          least_squared(settings.near_samples == NearSamples::clamped
                            ? kClampedSquare * settings.radius * settings.radius
                            : 0),
          inverse_squared(settings.radius * settings.radius > 0 ? 1 / (settings.radius * settings.radius)
                                                                : 0) {}

    template <class F>
    CREVICE_INLINE SampleFacts<F> sample(const TexelPoint<F>& texel, Vec3<F> n, Screen2<F> at) const {
        const FetchedPixel<F> pixel = fetch_pixel(inputs, at);
        const F zero(0), one(1), reach_squared = F(settings.radius) * F(settings.radius);
        const Vec3<F> delta = pixel.r - texel.p;
        const F own = dot(delta, delta), squared = max_of(own, F(least_squared));
        const auto counts =
            (own > own_point_squared(texel)) & (squared < reach_squared) & (pixel.r.z > F(inputs.near_plane));
        const F facing = select(counts, dot(n, delta) / square_root(select(counts, squared, one)), zero);
        const F weight = select(counts, saturate(one - squared * F(inverse_squared)), zero);
        return {pixel.r, pixel.at, pixel.r, facing, weight, saturate(facing - F(settings.bias)) * weight};
    }

    // Of a texel's turn.
    template <class F>
    CREVICE_INLINE F stored(F part) const {
        return settings.turns == TurnFormat::unorm8 ? as_unorm8(part) : part;
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const F length = length_px(inputs, ray_length, texel.p.z);
        const F shift = stored(noise.shift.at<F>(texel.x, texel.y));
        const F cosine = stored(noise.cosine.at<F>(texel.x, texel.y)),
                sine = stored(noise.sine.at<F>(texel.x, texel.y));
        const Vec3<F> n =
            settings.normals == NormalSource::depth ? normal_from_depth(inputs, texel) : texel.n;
        witness.tell_of_texel("radius_px", length);
        F sum(0);
        int number = 0;
        for (const glm::vec2& direction : directions) {
            const F x = F(direction.x) * cosine - F(direction.y) * sine,
                    y = F(direction.x) * sine + F(direction.y) * cosine;
            for (int step = 0; step < settings.steps; ++step) {
                const F along = ray_distance_px(step, settings.steps, shift, length);
                const SampleFacts<F> facts =
                    sample(texel, n, {texel.at.x + along * x, texel.at.y - along * y});
                sum = sum + facts.contribution;
                witness.tell("direction", Int<F>(number));
                witness.tell("step", Int<F>(step));
                witness(facts);
            }
            ++number;
        }
        return sum;
    }

    static float multiplier(const HbaoPlusSettings& settings) {
        return 2 / ((1 - settings.bias) * static_cast<float>(settings.samples));
    }
    template <class F>
    CREVICE_INLINE static F value(const HbaoPlusSettings& settings, F taken) {
        const F access = F(1) - taken * F(multiplier(settings));
        return with_contrast(access, settings.exponent);
    }

    static std::string formula(const HbaoPlusSettings& settings) {
        return contrast_formula("1 - sum * " + shortest_text(multiplier(settings)), settings.exponent);
    }
};

}  // namespace

void validate(const HbaoPlusSettings& s) {
    validate_screen_rays(s.samples, s.steps);
    require_within("bias", s.bias, 0, 0.9);
    require_common(s);
}

HbaoPlusSettings spelt_out(HbaoPlusSettings settings) {
    if (!settings.as_published) return settings;
    settings.as_published = false;
    settings.table = RayTable::listed;
    settings.turns = TurnFormat::unorm8;
    settings.projected_by = ProjectedBy::width;
    settings.near_samples = NearSamples::clamped;
    return settings;
}

AoMap hbao_plus(const AoInputs& inputs, const HbaoPlusSettings& settings, const Run& run) {
    validate(settings);
    return each_texel(HbaoPlusKernel(inputs, settings), settings, run);
}

double hbao_plus_reach_px(const AoInputs& inputs, const HbaoPlusSettings& settings, double view_depth) {
    const double length =
        static_cast<double>(settings.radius) * static_cast<double>(stretch(inputs, settings));
    return reach_of_length_px(inputs, length, view_depth);
}

Explanation explain_hbao_plus(const AoInputs& inputs, const HbaoPlusSettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(HbaoPlusKernel(inputs, settings), settings, x, y);
}

}  // namespace crevice
