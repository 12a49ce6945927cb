// The estimator that both tutorials share: up to 14 points around p, each compared with what the depth map
// shows there.
// Source: Luna, chapter 21, and X_Jun, chapter 32, who took it over; formulas and traps stand in the order of
//         their listings.
// Out:    accessibility in [0,1]: 1 - (1/N) sum of dp * occlusion(p_z - r_z), to the power `exponent`; and what
//         was decided of its tiles (open_tiles.h)
// Reach:  radius (RandomVectors::raw: up to 5 radius) in view space around p
// Differs from the tutorials: the random vector is normalised; a point q in front of the near plane is
//         rejected; sign(0) is +1; r = p counts nothing; fade_end = fade_start is a step. Settings restore
//         the first and third. It is a weighted vote, not cosine-weighted visibility: it does not converge
//         to ray-cast AO.
// Cost:   about 100 operations and four depth reads a sample; half of that where nothing is in front. The
//         tiles of open_tiles.h cost nothing.
#pragma once

#include <array>
#include <limits>

#include "rasterizer/lanes/approx_math.h"
#include "ssao/inputs/map_squares.h"
#include "ssao/inputs/random_vectors.h"
#include "ssao/methods/ao_map.h"
#include "ssao/methods/luna_settings.h"

namespace crevice {

// One AO map of what `inputs` see. 1 where there is no surface.
AoMap luna_occlusion(const AoInputs& inputs, const LunaSettings& settings, const Run& run);

// The same kernel in double, pixel by pixel, rounded at the end: what luna_occlusion() would be without
// rounding errors of its own. The exponent is taken by libm: to compare with, not to keep.
Image<float> luna_occlusion_in_double(const AoInputs& inputs, const LunaSettings& settings, const Run& run);

// ---- the kernel, for one texel or eight

// What the samples of a texel lie around.
template <class F>
struct LunaPoint {
    Vec3<F> p, n, random;  // view space; `random` as random_vector() has it
    Mask<F> surface;       // false: background, where the others mean nothing
};

struct LunaKernel {
    const AoInputs& inputs;
    LunaSettings settings;  // spelt out
    std::array<glm::vec3, kCubeVectors> offsets;
    float inverse_fade;  // 1 / (fade_end - fade_start), very large for a step
    float epsilon;       // infinite for radius 0: then q = p, which nothing occludes

    LunaKernel(const AoInputs& ao_inputs, const LunaSettings& luna)
        : inputs(ao_inputs), settings(spelt_out(luna)), offsets(cube_offsets(luna.seed)) {
        const float range = luna.fade_end - luna.fade_start;
        inverse_fade = range > 0 ? 1 / range : 3e38f;
        epsilon = luna.radius > 0 ? luna.epsilon : std::numeric_limits<float>::infinity();
    }

    // Where a screen position lies between the pixels of the depth map, outside the picture on its border.
    template <class F, class Depths>
    CREVICE_INLINE MapCell<F> cell_at(Screen2<F> p_screen, Depths& depths) const {
        const F width = F(static_cast<float>(inputs.picture.width)),
                height = F(static_cast<float>(inputs.picture.height));
        F x = p_screen.x - F(0.5f), y = p_screen.y - F(0.5f);
        if (inputs.fetch.border == MapBorder::wrap) x = wrapped(x, width), y = wrapped(y, height);
        x = min_of(max_of(x, F(-1)), width), y = min_of(max_of(y, F(-1)), height);
        const Int<F> x0 = floor_to_int(x), y0 = floor_to_int(y);
        return {depths.template index_of<F>(x0, y0), x - F(to_float(x0)), y - F(to_float(y0))};
    }

    // The same position in the picture that repeats every `count` pixels. From 2^20 pictures away on it stays
    // outside, where it is no position any more but a rounding error.
    template <class F>
    CREVICE_INLINE F wrapped(F position, F count) const {
        const F pictures = (position + F(0.5f)) / count, limit = F(1048576);
        const Int<F> whole = floor_to_int(min_of(max_of(pictures, F(0) - limit), limit));
        return position - F(to_float(whole)) * count;
    }

    CREVICE_INLINE WholeDepthMap whole_map() const {
        return {inputs.depth_map, inputs.in_double ? &inputs.in_double->depth_map : nullptr};
    }

    // View depth that the depth map shows there, filtered linearly.
    template <class F, class Depths>
    CREVICE_INLINE F depth_in(const MapCell<F>& cell, const Depths& depths) const {
        const auto pixels = depths.template square_at<F>(cell.upper_left);
        const F top = mix(F(pixels.upper_left), F(pixels.upper_right), cell.x);
        const F bottom = mix(F(pixels.lower_left), F(pixels.lower_right), cell.x);
        const F depth = mix(top, bottom, cell.y);
        return inputs.fetch.depth == DepthSource::view_depth ? depth : inputs.view_from_ndc(depth);
    }
    template <class F>
    CREVICE_INLINE F depth_at(Screen2<F> p_screen) const {
        const WholeDepthMap depths = whole_map();
        return depth_in(cell_at(p_screen, depths), depths);
    }

    // How far in front of a point at view depth z something must be to count: epsilon, or what rounding makes of it.
    template <class F>
    CREVICE_INLINE F nearest_occluder(F z) const {
        return max_of(F(epsilon), F(kViewDepthRounding) * z);
    }

    // How much an occluder `distance_z` in front of a point counts, in [0,1]; the point is at view depth p_z, at 0 nothing
    // is rounded away.
    template <class F>
    CREVICE_INLINE F occlusion(F distance_z, F p_z = F(0)) const {
        const F fading = saturate((F(settings.fade_end) - distance_z) * F(inverse_fade));
        return select(distance_z > nearest_occluder(p_z), fading, F(0));
    }

    // The point q around p that one offset vector leads to.
    template <class F>
    CREVICE_INLINE Vec3<F> sample_point(Vec3<F> p, Vec3<F> n, Vec3<F> random, const glm::vec3& offset) const {
        const Vec3<F> o = spread<F>(offset);
        const Vec3<F> d = o - F(2) * dot(o, random) * random;
        const F facing = dot(d, n), radius = F(settings.radius);
        F length = select(facing < F(0), -radius, radius);
        if (settings.sign_of_zero == SignOfZero::zero) length = select(facing == F(0), F(0), length);
        return p + length * d;
    }

    // q in front of the near plane projects nowhere, behind the eye it would be mirrored.
    template <class F>
    CREVICE_INLINE Mask<F> visible(F q_z) const {
        return q_z > F(inputs.near_plane);
    }
    template <class F>
    CREVICE_INLINE F inverse_depth(F q_z) const {
        return F(1) / select(visible(q_z), q_z, F(1));
    }

    // The tutorials' dp: how squarely the surface at view depth r_z, seen in the direction of q, lies over p, in
    // [0,1] for a unit normal.
    template <class F>
    CREVICE_INLINE F facing(Vec3<F> p, Vec3<F> n, Vec3<F> q, F inverse_z, F r_z) const {
        const Vec3<F> from_p = inputs.rays.at_depth(q, inverse_z, r_z) - p;
        const F squared = dot(from_p, from_p);
        const auto apart = squared > F(settings.radius) * F(settings.radius) * F(1e-12f);
        const F along_n = dot(n, from_p) / square_root(select(apart, squared, F(1)));
        return select(apart & visible(q.z) & (along_n > F(0)), along_n, F(0));
    }

    // What that surface takes from p.
    template <class F>
    CREVICE_INLINE F contribution(Vec3<F> p, Vec3<F> n, Vec3<F> q, F inverse_z, F r_z) const {
        if (!settings.self_occlusion_test) return select(visible(q.z), occlusion(p.z - r_z, p.z), F(0));
        return facing(p, n, q, inverse_z, r_z) * occlusion(p.z - r_z, p.z);
    }

    // What one offset vector contributes: where it leads, what the depth map shows there, what that takes.
    template <class F>
    CREVICE_INLINE F sample(Vec3<F> p, Vec3<F> n, Vec3<F> random, const glm::vec3& offset) const {
        const Vec3<F> q = sample_point(p, n, random, offset);
        const F inverse_z = inverse_depth(q.z);
        return contribution(p, n, q, inverse_z, depth_at(inputs.rays.p_screen(q, inverse_z)));
    }

    // 1 - the mean of all samples, before the exponent.
    template <class F>
    CREVICE_INLINE F accessibility(Vec3<F> p, Vec3<F> n, Vec3<F> random) const {
        const WholeDepthMap depths = whole_map();
        return accessibility_from(p, n, random, depths);
    }

    // The same with the depths of another source, which is asked for the cells of all samples in order, then
    // for their pixels. A loop a step of sample(): one sample is a long chain of operations that wait for
    // each other, and the processor overlaps the short chains of a step better (twice as fast). The steps
    // keep plain arrays, not structs, which GCC copies through memory.
    template <class F, class Depths>
    CREVICE_INLINE F accessibility_from(Vec3<F> p, Vec3<F> n, Vec3<F> random, Depths& depths) const {
        F q_x[kCubeVectors], q_y[kCubeVectors], q_z[kCubeVectors], inverse_z[kCubeVectors];
        for (int i = 0; i < settings.samples; ++i) {
            const Vec3<F> q = sample_point(p, n, random, offsets[static_cast<std::size_t>(i)]);
            q_x[i] = q.x;
            q_y[i] = q.y;
            q_z[i] = q.z;
            inverse_z[i] = inverse_depth(q.z);
        }
        Int<F> cell[kCubeVectors];
        F cell_x[kCubeVectors], cell_y[kCubeVectors];
        for (int i = 0; i < settings.samples; ++i) {
            const MapCell<F> at =
                cell_at(inputs.rays.p_screen<F>({q_x[i], q_y[i], q_z[i]}, inverse_z[i]), depths);
            cell[i] = at.upper_left;
            cell_x[i] = at.x;
            cell_y[i] = at.y;
        }
        F r_z[kCubeVectors];
        auto occluded = F(0) > F(0);
        const F nearest = nearest_occluder(p.z);
        for (int i = 0; i < settings.samples; ++i) {
            r_z[i] = depth_in(MapCell<F>{cell[i], cell_x[i], cell_y[i]}, depths);
            occluded = occluded | (p.z - r_z[i] > nearest);
        }
        if (!any(occluded)) return F(1);
        F sum = F(0);
        for (int i = 0; i < settings.samples; ++i)
            sum = sum + contribution(p, n, {q_x[i], q_y[i], q_z[i]}, inverse_z[i], r_z[i]);
        return accessibility_of_sum(sum);
    }
    template <class F>
    CREVICE_INLINE F accessibility_of_sum(F sum) const {
        return F(1) - sum / F(static_cast<float>(settings.samples));
    }

    // What the offsets of a texel at uv are mirrored at; 0 leaves them as they are.
    template <class F>
    CREVICE_INLINE Vec3<F> random_vector(const RandomMap& map, F u, F v) const {
        if (settings.random_vectors == RandomVectors::none) return {F(0), F(0), F(0)};
        const Vec3<F> r = map.sample(F(kRandomMapRepeats) * u, F(kRandomMapRepeats) * v);
        return settings.random_vectors == RandomVectors::raw ? r : normalize_or<F>(r, {F(0), F(0), F(1)});
    }

    // Of the texels from (x, y) on.
    template <class F>
    CREVICE_INLINE LunaPoint<F> point_at(const RandomMap& map, int x, int y) const {
        const Size size = inputs.size();
        const F z = inputs.texel_depth<F>(x, y);
        const auto surface = z < F(std::numeric_limits<float>::infinity());
        const F u = (F(to_float(lane_index<F>() + Int<F>(x))) + F(0.5f)) / F(static_cast<float>(size.width));
        const F v = (F(static_cast<float>(y)) + F(0.5f)) / F(static_cast<float>(size.height));
        const Vec3<F> n = inputs.texel_normal<F>(x, y),
                      p = inputs.rays.p_view(u, v, select(surface, z, F(1)));
        return {p, n, random_vector(map, u, v), surface};
    }

    // An accessibility with its contrast, as the map holds it.
    template <class F>
    CREVICE_INLINE F stored(F access) const {
        const F contrast = saturate(power(max_of(access, F(0)), F(settings.exponent)));
        return stored_as(contrast, settings.format);
    }

    // Accessibility before its contrast, of the texels from (x, y) on; 1 where there is no surface.
    template <class F, class Depths>
    CREVICE_INLINE F accessibility_at(const RandomMap& map, int x, int y, Depths& depths) const {
        const LunaPoint<F> at = point_at<F>(map, x, y);
        return select(at.surface, accessibility_from(at.p, at.n, at.random, depths), F(1));
    }
    // AO as it is stored; the contrast of 1 is 1.
    template <class F, class Depths>
    CREVICE_INLINE F texels_at(const RandomMap& map, int x, int y, Depths& depths) const {
        return stored(accessibility_at<F>(map, x, y, depths));
    }
};

}  // namespace crevice
