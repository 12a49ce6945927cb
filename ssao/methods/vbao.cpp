#include "ssao/methods/vbao.h"

#include <algorithm>

#include "ssao/methods/screen_rays.h"
#include "ssao/methods/sector_bits.h"
#include "ssao/methods/settings_range.h"
#include "ssao/methods/slices.h"

namespace crevice {

namespace {

// Thicker things are this many radii thick: far beyond what an angle tells, and no square overflows.
constexpr float kThickest = 1e6f;

struct VbaoKernel {
    const AoInputs& inputs;
    const VbaoSettings settings;
    const SlicePlan plan;
    const SliceNoise noise;
    const float thickness;

    VbaoKernel(const AoInputs& ao_inputs, const VbaoSettings& vbao)
        : inputs(ao_inputs),
          settings(vbao),
          plan(slice_plan(vbao.samples)),
          noise(vbao.seed, plan.slices),
          thickness(std::min(vbao.thickness, kThickest * vbao.radius)) {}

    // One side of a slice, as if it were the positive one.
    template <class F>
    struct Side {
        float sign;  // 1 or -1
        F cosine, sine, gamma;
    };

    // The share of the slice's sectors between an angle from v, given by its cosine, and the open horizon.
    template <class F>
    CREVICE_INLINE F share_beyond(F c, const Slice<F>& slice, const Side<F>& side) const {
        if (settings.sectors == Sectors::cosine)
            return closed_beyond(c, side.cosine, side.sine, side.gamma) / slice.open;
        return (side.gamma + F(static_cast<float>(kPi / 2)) - arc_cosine(c)) * F(static_cast<float>(1 / kPi));
    }

    // The sectors between two shares of them, counted from the open horizon of this side.
    template <class F>
    CREVICE_INLINE Int<F> closed_sectors(F front, F back, float sign) const {
        const F all(kSectors), near = saturate(back) * all, far = saturate(front) * all;
        const bool touched = settings.closed == ClosedSectors::touched;
        const Int<F> first = floor_to_int(touched ? near : near + F(0.5f));
        const Int<F> end = touched ? Int<F>(0) - floor_to_int(F(0) - far) : floor_to_int(far + F(0.5f));
        const Int<F> count(kSectors), last = max_of(end, first);
        return sign > 0 ? bits_between(first, last) : bits_between(count - last, count - first);
    }

    // What one sample closes and none before it has; `mask` are the sectors that are closed.
    template <class F>
    CREVICE_INLINE SampleFacts<F> sample(const TexelPoint<F>& texel, const Slice<F>& slice,
                                         const Side<F>& side, Screen2<F> at, Int<F>& mask) const {
        const FetchedPixel<F> pixel = fetch_pixel(inputs, at);
        const F zero(0), one(1), reach_squared = F(settings.radius) * F(settings.radius);
        const Vec3<F> delta = pixel.r - texel.p, behind = delta - F(thickness) * slice.v;
        const F squared = dot(delta, delta), squared_behind = dot(behind, behind),
                least = reach_squared * F(1e-12f);
        const auto counts = (squared > least) & (squared <= reach_squared) & (squared_behind > least) &
                            (pixel.r.z > F(inputs.near_plane));
        const Vec3<F> front = (one / square_root(select(counts, squared, one))) * delta,
                      back = (one / square_root(select(counts, squared_behind, one))) * behind;
        const F nearer =
                    share_beyond(cosine_beside(front, texel.n, slice.v, side.cosine, side.sine), slice, side),
                further =
                    share_beyond(cosine_beside(back, texel.n, slice.v, side.cosine, side.sine), slice, side);
        // Where nothing counts the shares are those of no direction.
        const Int<F> covered =
            closed_sectors(select(counts, nearer, zero), select(counts, further, zero), side.sign);
        const Int<F> fresh = bits_outside(covered, mask);
        mask = mask | fresh;
        const F weight = settings.sectors == Sectors::cosine ? slice.length * slice.open : one;
        return {pixel.r,
                pixel.at,
                pixel.r,
                select(counts, dot(texel.n, front), zero),
                select(counts, one, zero),
                F(to_float(bit_count(fresh))) * F(1.0f / kSectors) * weight};
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const F radius_px = length_px(inputs, settings.radius, texel.p.z);
        const F shift = noise.step.at<F>(texel.x, texel.y);
        const F cosine = noise.cosine.at<F>(texel.x, texel.y), sine = noise.sine.at<F>(texel.x, texel.y);
        F sum(0);
        for (int i = 0; i < plan.slices; ++i) {
            const SineCosine base = sine_cosine(kPi * i / plan.slices);
            const F x = F(static_cast<float>(base.cosine)), y = F(static_cast<float>(base.sine));
            const Slice<F> slice = slice_of(texel, inputs, x * cosine - y * sine, x * sine + y * cosine);
            Int<F> mask(0);
            for (const float sign : {1.0f, -1.0f}) {
                const Side<F> side{sign, slice.cosine, F(sign) * slice.sine, F(sign) * slice.gamma};
                for (int step = 0; step < plan.steps; ++step) {
                    const F along = F(sign) * step_distance_px(i, step, plan, shift, radius_px);
                    const SampleFacts<F> facts =
                        sample(texel, slice, side,
                               {texel.at.x + along * slice.x, texel.at.y + along * slice.y}, mask);
                    sum = sum + facts.contribution;
                    witness(facts);
                }
            }
        }
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const VbaoSettings& settings, F taken) {
        const F access = F(1) - taken / F(static_cast<float>(slice_plan(settings.samples).slices));
        return saturate(power(max_of(access, F(0)), F(settings.exponent)));
    }
};

}  // namespace

void validate(const VbaoSettings& s) {
    validate_slice_samples(s.samples);
    require_length("radius", s.radius);
    require_length("thickness", s.thickness);
    require_within("exponent", s.exponent, 0, 64);
    ao_map_size({1, 1}, s.ao_scale);  // which refuses what is no scale
}

AoFetch vbao_fetch(const VbaoSettings& settings) {
    return {.depth = DepthSource::view_depth, .point_normals = true, .scale = settings.ao_scale};
}

AoMap vbao(const AoInputs& inputs, const VbaoSettings& settings, const Run& run) {
    validate(settings);
    return each_texel(VbaoKernel(inputs, settings), settings, run);
}

double vbao_reach_px(const AoInputs& inputs, const VbaoSettings& settings, double view_depth) {
    constexpr double kNextPixel = 2;
    return length_px(inputs, 1.0f, view_depth) * static_cast<double>(settings.radius) + kNextPixel;
}

Explanation explain_vbao(const AoInputs& inputs, const VbaoSettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(VbaoKernel(inputs, settings), settings, x, y);
}

}  // namespace crevice
