#include "ssao/methods/unity.h"

#include <cmath>
#include <limits>

#include "rasterizer/lanes/approx_math.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

constexpr HemisphereLengths kUnityLengths = {.shortest = 0.01f, .shortened = false};
constexpr float kFullWeight = 0.2f;         // radii across the view from which on a point counts fully
constexpr float kFixedTurn = 0.577350269f;  // of (1, 1, 1), normalised

// (far - near) / (far + near), which follows from the matrix's z row: there far / (far - near) stands, or with
// reversed z -near / (far - near).
float shrink_by_z(const AoInputs& inputs) {
    return inputs.rays.perspective ? 1 / std::fabs(2 * inputs.depth_a - 1) : 1;
}

struct UnityKernel {
    const AoInputs& inputs;
    const UnitySettings settings;  // spelt out
    const std::vector<glm::vec3> points;
    const TurnTile turns;
    // Scene units; the bias is infinite for radius 0: then q = p, which nothing occludes.
    const float bias, range;
    const float shrink;

    UnityKernel(const AoInputs& ao_inputs, const UnitySettings& unity)
        : inputs(ao_inputs),
          settings(spelt_out(unity)),
          points(unity_offsets(settings)),
          turns(TurnVectors::circle, settings.seed),
          bias(settings.radius > 0 ? settings.bias * settings.radius
                                   : std::numeric_limits<float>::infinity()),
          range(settings.range * settings.radius),
          shrink(settings.divided_by_z ? shrink_by_z(inputs) : 1) {}

    template <class F, class Witness>
    CREVICE_INLINE SampleFacts<F> sample(const TexelPoint<F>& texel, Vec3<F> offset,
                                         const Witness& witness) const {
        const Vec3<F> q = texel.p + F(settings.radius) * offset;
        const SeenPoint<F> seen = seen_point(inputs, q, shrink);
        const Vec3<F> r = seen.pixel.r, from_p = r - texel.p;
        const F height = dot(texel.n, from_p);
        const F behind = settings.compared_depth == ComparedDepth::point ? q.z : texel.p.z;
        auto hidden = seen.visible & (r.z + F(bias) < behind);
        if (settings.self_occlusion == SelfOcclusion::plane) hidden = hidden & (height > F(bias));
        witness.tell("height", height);
        F weight = select(absolute(from_p.z) > F(range), F(0), F(1));
        if (settings.weight_smoothing) {
            const F across = square_root(offset.x * offset.x + offset.y * offset.y);
            weight = weight * smooth_step(across / F(kFullWeight));
        }
        const F contribution = settings.counted_points == CountedPoints::open
                                   ? F(1) - select(hidden, F(0), weight)
                                   : select(hidden, weight, F(0));
        return {.q = q,
                .at = seen.pixel.at,
                .r = r,
                .facing = cosine_over(from_p, height, settings.radius),
                .weight = weight,
                .contribution = contribution};
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const F fixed(kFixedTurn);
        const Vec3<F> turn = settings.random_basis ? turns.at(texel, inputs.picture, inputs.size())
                                                   : Vec3<F>{fixed, fixed, fixed};
        const F n_z = settings.mirrored_z ? F(0) - texel.n.z : texel.n.z;
        const SurfaceFrame<F> frame = frame_over<F>({texel.n.x, texel.n.y, n_z}, turn);
        F sum(0);
        for (const glm::vec3& point : points) {
            const SampleFacts<F> facts = sample(texel, frame.turned(point), witness);
            witness(facts);
            sum = sum + facts.contribution;
        }
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const UnitySettings& settings, F taken) {
        const F mean = taken / F(static_cast<float>(settings.samples));
        const bool as_open = settings.counted_points == CountedPoints::hidden_as_open;
        const F access = as_open ? mean : F(1) - mean;
        return with_contrast(access, settings.exponent);
    }

    static std::string formula(const UnitySettings& settings) {
        if (settings.counted_points == CountedPoints::hidden_as_open)
            return contrast_formula("sum / " + std::to_string(settings.samples), settings.exponent);
        return mean_formula(settings.samples, settings.exponent);
    }
};

}  // namespace

void validate(const UnitySettings& s) {
    require_within("samples", s.samples, 1, 64);
    require_length("range", s.range);
    require_within("bias", s.bias, 0, 1);
    require_common(s);
}

UnitySettings spelt_out(UnitySettings s) {
    if (!s.as_published) return s;
    s.compared_depth = ComparedDepth::centre;
    s.self_occlusion = SelfOcclusion::depth;
    s.counted_points = CountedPoints::hidden_as_open;
    s.mirrored_z = true;
    s.divided_by_z = true;
    return s;
}

std::vector<glm::vec3> unity_offsets(const UnitySettings& settings) {
    return hemisphere_points(settings.samples, kUnityLengths, settings.seed);
}

AoMap unity_ao(const AoInputs& inputs, const UnitySettings& settings, const Run& run) {
    validate(settings);
    const UnityKernel kernel(inputs, settings);
    return each_texel(kernel, kernel.settings, run);
}

double unity_reach_px(const AoInputs& inputs, const UnitySettings& settings, double view_depth) {
    return hemisphere_reach_px(inputs, static_cast<double>(settings.radius), view_depth);
}

Explanation explain_unity(const AoInputs& inputs, const UnitySettings& settings, int x, int y) {
    validate(settings);
    const UnityKernel kernel(inputs, settings);
    return explain_texel(kernel, kernel.settings, x, y);
}

}  // namespace crevice
