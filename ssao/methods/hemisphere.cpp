#include "ssao/methods/hemisphere.h"

#include <algorithm>
#include <limits>

#include "rasterizer/lanes/approx_math.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr HemisphereLengths kHemisphereLengths = {.shortest = 0.1f, .shortened = true};

// View depth from which on a pixel shows the background: between the far plane and kBackgroundOverFar of it,
// away from both, for the far plane that follows from the matrix is not exact.
float background_from(const AoInputs& inputs) {
    const float ends[] = {inputs.view_from_ndc(0.0f), inputs.view_from_ndc(1.0f)};
    const float far_plane = std::max(ends[0], ends[1]);
    return far_plane > 0 ? far_plane * (kBackgroundOverFar / 10) : kInfinity;
}

struct HemisphereKernel {
    const AoInputs& inputs;
    const HemisphereSettings settings;  // spelt out
    const std::vector<glm::vec3> points;
    const TurnTile turns;
    const Size turned_as;      // the size of map that the tile of turns is laid over
    const float bias;          // infinite for radius 0: then q = p, which nothing occludes
    const float cleared_from;  // view depth from which on a pixel lies at the eye

    HemisphereKernel(const AoInputs& ao_inputs, const HemisphereSettings& hemisphere)
        : inputs(ao_inputs),
          settings(spelt_out(hemisphere)),
          points(hemisphere_offsets(settings)),
          turns(settings.turn_vectors, settings.seed),
          turned_as(settings.turns_for_1024 ? Size{1024, 1024} : inputs.size()),
          bias(settings.radius > 0 ? settings.bias : kInfinity),
          cleared_from(settings.background == BackgroundPosition::at_eye ? background_from(inputs)
                                                                         : kInfinity) {}

    template <class F, class Witness>
    CREVICE_INLINE SampleFacts<F> sample(const TexelPoint<F>& texel, Vec3<F> q,
                                         const Witness& witness) const {
        const SeenPoint<F> seen = seen_point(inputs, q);
        const auto cleared = seen.pixel.r.z >= F(cleared_from);
        const Vec3<F> r = select<F>(cleared, {F(0), F(0), F(0)}, seen.pixel.r), from_p = r - texel.p;
        const F height = dot(texel.n, from_p);
        auto hidden = seen.visible & (r.z <= q.z - F(bias));
        if (settings.self_occlusion == SelfOcclusion::plane) hidden = hidden & (height > F(bias));
        witness.tell("height", height);
        const F weight = settings.range_check ? range_weight(texel.p.z - r.z, settings.radius) : F(1);
        return {.q = q,
                .at = seen.pixel.at,
                .r = r,
                .facing = cosine_over(from_p, height, settings.radius),
                .weight = weight,
                .contribution = select(hidden, weight, F(0))};
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const SurfaceFrame<F> frame = frame_over(texel.n, turns.at(texel, inputs.picture, turned_as));
        F sum(0);
        for (const glm::vec3& point : points) {
            const SampleFacts<F> facts =
                sample<F>(texel, texel.p + F(settings.radius) * frame.turned(point), witness);
            witness(facts);
            sum = sum + facts.contribution;
        }
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const HemisphereSettings& settings, F taken) {
        const F access = F(1) - taken / F(static_cast<float>(settings.samples));
        return with_contrast(access, settings.exponent);
    }

    static std::string formula(const HemisphereSettings& settings) {
        return mean_formula(settings.samples, settings.exponent);
    }
};

}  // namespace

void validate(const HemisphereSettings& s) {
    require_within("samples", s.samples, 1, 256);
    require_length("bias", s.bias);
    require_common(s);
}

HemisphereSettings spelt_out(HemisphereSettings s) {
    if (!s.as_published) return s;
    s.self_occlusion = SelfOcclusion::depth;
    s.background = BackgroundPosition::at_eye;
    s.border = MapBorder::edge;
    s.unit_normals = false;
    s.turn_vectors = TurnVectors::square;
    s.turns_for_1024 = true;
    return s;
}

AoFetch hemisphere_fetch(const HemisphereSettings& settings) {
    const HemisphereSettings s = spelt_out(settings);
    return {.depth = DepthSource::view_depth,
            .point_normals = s.unit_normals,
            .scale = s.ao_scale,
            .border = s.border};
}

std::vector<glm::vec3> hemisphere_offsets(const HemisphereSettings& settings) {
    return hemisphere_points(settings.samples, kHemisphereLengths, settings.seed);
}

AoMap hemisphere_ao(const AoInputs& inputs, const HemisphereSettings& settings, const Run& run) {
    validate(settings);
    return each_texel(HemisphereKernel(inputs, settings), settings, run);
}

double hemisphere_reach_px(const AoInputs& inputs, const HemisphereSettings& settings, double view_depth) {
    return hemisphere_reach_px(inputs, static_cast<double>(settings.radius), view_depth);
}

Explanation explain_hemisphere(const AoInputs& inputs, const HemisphereSettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(HemisphereKernel(inputs, settings), settings, x, y);
}

}  // namespace crevice
