// The visibility bitmask's kernel (see vbao.h): one text for maps, explanations and the book's diagrams.
#pragma once

#include <algorithm>
#include <vector>

#include "ssao/methods/screen_rays.h"
#include "ssao/methods/sector_bits.h"
#include "ssao/methods/slices.h"
#include "ssao/methods/vbao.h"

namespace crevice {

// Thicker things are this many radii thick: far beyond what an angle tells, and no square overflows.
inline constexpr float kThickest = 1e6f;

struct VbaoKernel {
    const AoInputs& inputs;
    const VbaoSettings settings;
    const SlicePlan plan;
    const std::vector<glm::vec2> directions;
    const SliceNoise noise;
    const float thickness;

    VbaoKernel(const AoInputs& ao_inputs, const VbaoSettings& vbao)
        : inputs(ao_inputs),
          settings(vbao),
          plan(slice_plan(vbao.samples)),
          directions(slice_directions(plan.slices)),
          noise(vbao.seed, plan.slices),
          thickness(std::min(vbao.thickness, kThickest * vbao.radius)) {}

    // One side of a slice, as if it were the positive one.
    template <class F>
    struct Side {
        float sign;  // 1 or -1
        F cosine, sine, gamma;
        F sectors;  // over the measure that they share: the whole integral, or pi
    };
    template <class F>
    CREVICE_INLINE Side<F> side_of(const Slice<F>& slice, float sign) const {
        const F all(kSectors), pi = F(static_cast<float>(kPi));
        return {sign, slice.cosine, F(sign) * slice.sine, F(sign) * slice.gamma,
                settings.sectors == Sectors::cosine ? all / slice.open : all / pi};
    }

    // How many sectors lie between a direction and the open horizon of its side.
    template <class F>
    CREVICE_INLINE F sectors_beyond(Vec3<F> d, const TexelPoint<F>& texel, const Slice<F>& slice,
                                    const Side<F>& side) const {
        const F c = cosine_beside(d, texel.n, slice.v, side.cosine, side.sine);
        const F beyond = settings.sectors == Sectors::cosine
                             ? closed_beyond(c, side.cosine, side.sine, side.gamma)
                             : side.gamma + F(static_cast<float>(kPi / 2)) - arc_cosine(c);
        return min_of(max_of(beyond * side.sectors, F(0)), F(kSectors));
    }

    // The first sector that counts as closed by a thing with its back there, and the one after the last by its front.
    template <class F>
    CREVICE_INLINE Int<F> first_covered(F sectors) const {
        return floor_to_int(settings.closed == ClosedSectors::touched ? sectors : sectors + F(0.5f));
    }
    template <class F>
    CREVICE_INLINE Int<F> end_of_covered(F sectors) const {
        if (settings.closed == ClosedSectors::middle) return floor_to_int(sectors + F(0.5f));
        return Int<F>(0) - floor_to_int(F(0) - sectors);
    }

    // What one sample closes and none before it has; `mask` are the sectors that are closed.
    template <class F, class Witness = NoWitness>
    CREVICE_INLINE SampleFacts<F> sample(const TexelPoint<F>& texel, const Slice<F>& slice,
                                         const Side<F>& side, Screen2<F> at, Int<F>& mask,
                                         const Witness& witness = {}) const {
        const FetchedPixel<F> pixel = fetch_pixel(inputs, at);
        const F zero(0), one(1), reach_squared = F(settings.radius) * F(settings.radius);
        const Vec3<F> delta = pixel.r - texel.p, behind = delta - F(thickness) * slice.v;
        const F squared = dot(delta, delta), squared_behind = dot(behind, behind),
                least = own_point_squared(texel);
        const auto counts = (squared > least) & (squared <= reach_squared) & (squared_behind > least) &
                            (pixel.r.z > F(inputs.near_plane)) & (F(thickness) > zero);
        const Vec3<F> front = (one / square_root(select(counts, squared, one))) * delta;
        const Int<F> none(0), all(kSectors);
        const Int<F> end = select(counts, end_of_covered(sectors_beyond(front, texel, slice, side)), none);
        SampleFacts<F> facts{
            pixel.r, pixel.at, pixel.r, select(counts, dot(texel.n, front), zero), select(counts, one, zero),
            zero};
        // Most samples lie on the open plane, and have no back either.
        if (!any(end > none)) return facts;
        const Vec3<F> back = (one / square_root(select(counts, squared_behind, one))) * behind;
        const Int<F> first = min_of(first_covered(sectors_beyond(back, texel, slice, side)), end);
        const Int<F> covered =
            side.sign > 0 ? bits_between(first, end) : bits_between(all - end, all - first);
        const Int<F> fresh = select(counts, bits_outside(covered, mask), none);
        mask = mask | fresh;
        witness.tell("first_sector", first);
        witness.tell("end_sector", end);
        witness.tell_bits("covered_bits", covered);
        witness.tell_bits("newly_closed_bits", fresh);
        const F weight = settings.sectors == Sectors::cosine ? slice.length * slice.open : one;
        facts.contribution = F(to_float(bit_count(fresh))) * F(1.0f / kSectors) * weight;
        return facts;
    }

    template <class F, class Witness>
    CREVICE_INLINE F taken(const TexelPoint<F>& texel, const Witness& witness) const {
        const F radius_px = length_px(inputs, settings.radius, texel.p.z);
        const F shift = noise.step.at<F>(texel.x, texel.y);
        const F cosine = noise.cosine.at<F>(texel.x, texel.y), sine = noise.sine.at<F>(texel.x, texel.y);
        witness.tell_of_texel("radius_px", radius_px);
        F sum(0);
        for (int i = 0; i < plan.slices; ++i) {
            const glm::vec2& direction = directions[static_cast<std::size_t>(i)];
            const F x = F(direction.x), y = F(direction.y);
            const Slice<F> slice = slice_of(texel, inputs, x * cosine - y * sine, x * sine + y * cosine);
            Int<F> mask(0);
            for (const float sign : {1.0f, -1.0f}) {
                const Side<F> side = side_of(slice, sign);
                for (int step = 0; step < plan.steps; ++step) {
                    witness.tell("slice", Int<F>(i));
                    witness.tell("side", F(sign));
                    const F along = F(sign) * step_distance_px(i, step, plan, shift, radius_px);
                    const SampleFacts<F> facts =
                        sample(texel, slice, side,
                               {texel.at.x + along * slice.x, texel.at.y + along * slice.y}, mask, witness);
                    sum = sum + facts.contribution;
                    witness.tell_bits("closed_bits", mask);
                    witness(facts);
                }
            }
        }
        return sum;
    }

    template <class F>
    CREVICE_INLINE static F value(const VbaoSettings& settings, F taken) {
        const F access = F(1) - taken / F(static_cast<float>(slice_plan(settings.samples).slices));
        return with_contrast(access, settings.exponent);
    }

    static std::string formula(const VbaoSettings& settings) {
        return mean_formula(slice_plan(settings.samples).slices, settings.exponent);
    }
};

}  // namespace crevice
