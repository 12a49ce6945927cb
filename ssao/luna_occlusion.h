// The estimator that both tutorials share: up to 14 points around p, each compared with what the depth map
// shows there.
// Source: Luna 2016, ch. 21 (seed 002); Shen's X_Jun port (seed 000); formulas and traps in the order of the
//         seeds' listings.
// Out:    accessibility in [0,1]: 1 - (1/N) sum of dp * occlusion(p_z - r_z), to the power `exponent`
// Reach:  radius (as_published: up to 5 radius, the random vector is not unit) in view space around p
// Differs from the tutorials: the random vector is normalised; a point q in front of the near plane is
//         rejected; sign(0) is +1; r = p counts nothing; fade_end = fade_start is a step. `as_published`
//         restores the first and third. It is a weighted vote, not cosine-weighted visibility: it does not
//         converge to ray-cast AO.
// Cost:   about 70 operations and four depth reads a sample.
#pragma once

#include <array>
#include <cstdint>

#include "rasterizer/approx_math.h"
#include "rasterizer/half.h"
#include "ssao/ao_inputs.h"
#include "ssao/random_vectors.h"

namespace crevice {

struct LunaSettings {
    int samples = 14;         // [1, 14]; fewer is faster and noisier
    float radius = 0.5f;      // [0, inf) scene units; how far from p the samples lie
    float fade_start = 0.2f;  // [0, inf) scene units; occluders up to this far in front of p count fully
    float fade_end =
        2.0f;  // [fade_start, inf) scene units; occluders further in front of p than this do not count
    float epsilon = 0.05f;      // [0, inf) scene units; occluders less than this in front of p do not count
    float exponent = 4;         // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;     // of the offset lengths and the random map
    bool as_published = false;  // the tutorial's text, traps included
    float ao_scale = 0.5f;      // 0.5 or 1; AO map size over picture size
    BufferFormat format = BufferFormat::float32;  // of the AO map
};

// Throws UsageError naming the first member out of its range.
void validate(const LunaSettings& settings);

// One AO map of what `inputs` see. 1 where there is no surface.
Image<float> luna_occlusion(const AoInputs& inputs, const LunaSettings& settings, const Run& run);

// ---- the kernel, for one texel or eight

struct LunaKernel {
    const AoInputs& inputs;
    const LunaSettings& settings;
    std::array<glm::vec3, kCubeVectors> offsets;
    float inverse_fade;  // 1 / (fade_end - fade_start), very large for a step

    LunaKernel(const AoInputs& ao_inputs, const LunaSettings& luna)
        : inputs(ao_inputs), settings(luna), offsets(cube_offsets(luna.seed)) {
        const float range = luna.fade_end - luna.fade_start;
        inverse_fade = range > 0 ? 1 / range : 3e38f;
    }

    // View depth that the depth map shows at a screen position, filtered linearly.
    template <class F>
    CREVICE_INLINE F depth_at(Screen2<F> p_screen) const {
        const Image<float>& map = inputs.depth_map;
        const F width = F(static_cast<float>(inputs.picture.width)),
                height = F(static_cast<float>(inputs.picture.height));
        const F x = min_of(max_of(p_screen.x - F(0.5f), F(-1)), width),
                y = min_of(max_of(p_screen.y - F(0.5f), F(-1)), height);
        const Int<F> x0 = floor_to_int(x), y0 = floor_to_int(y);
        const F fx = x - F(to_float(x0)), fy = y - F(to_float(y0));
        const Int<F> at = (y0 + Int<F>(1)) * Int<F>(map.stride) + x0 + Int<F>(1);
        const auto upper = gather_pair(map.pixels.data(), at),
                   lower = gather_pair(map.pixels.data() + map.stride, at);
        const F top = mix(F(upper.first), F(upper.second), fx);
        const F bottom = mix(F(lower.first), F(lower.second), fx);
        const F depth = mix(top, bottom, fy);
        return inputs.fetch.depth == DepthSource::view_depth ? depth : inputs.view_from_ndc(depth);
    }

    // How much an occluder `distance_z` in front of p counts, in [0,1].
    template <class F>
    CREVICE_INLINE F occlusion(F distance_z) const {
        const F fading = saturate((F(settings.fade_end) - distance_z) * F(inverse_fade));
        return select(distance_z > F(settings.epsilon), fading, F(0));
    }

    // What one offset vector contributes, in [0,1] for a unit normal.
    template <class F>
    CREVICE_INLINE F sample(Vec3<F> p, Vec3<F> n, Vec3<F> random, const glm::vec3& offset) const {
        if (settings.radius == 0) return F(0);  // q = p, which nothing occludes
        const Vec3<F> o = spread<F>(offset);
        const Vec3<F> d = o - F(2) * dot(o, random) * random;
        const F facing = dot(d, n);
        F flip = select(facing < F(0), F(-1), F(1));
        if (settings.as_published) flip = select(facing == F(0), F(0), flip);
        const Vec3<F> q = p + flip * F(settings.radius) * d;

        // q in front of the near plane projects nowhere, behind the eye it would be mirrored.
        const auto visible = q.z > F(inputs.near_plane);
        const F inverse_z = F(1) / select(visible, q.z, F(1));
        const F r_z = depth_at(inputs.rays.p_screen(q, inverse_z));
        const Vec3<F> from_p = inputs.rays.at_depth(q, inverse_z, r_z) - p;

        const F squared = dot(from_p, from_p);
        const auto apart = squared > F(settings.radius) * F(settings.radius) * F(1e-12f);
        const F along_n = dot(n, from_p) / square_root(select(apart, squared, F(1)));
        const F dp = select(apart & visible & (along_n > F(0)), along_n, F(0));
        return dp * occlusion(p.z - r_z);
    }

    // 1 - the mean of all samples, before the exponent.
    template <class F>
    CREVICE_INLINE F accessibility(Vec3<F> p, Vec3<F> n, Vec3<F> random) const {
        F sum = F(0);
        for (int i = 0; i < settings.samples; ++i)
            sum = sum + sample(p, n, random, offsets[static_cast<std::size_t>(i)]);
        return F(1) - sum / F(static_cast<float>(settings.samples));
    }

    // The random vector of a texel at uv, unit unless as published.
    template <class F>
    CREVICE_INLINE Vec3<F> random_vector(const RandomMap& map, F u, F v) const {
        const Vec3<F> r = map.sample(F(kRandomMapRepeats) * u, F(kRandomMapRepeats) * v);
        return settings.as_published ? r : normalize_or<F>(r, {F(0), F(0), F(1)});
    }
};

}  // namespace crevice
