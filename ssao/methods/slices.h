// Slices of the hemisphere: half-planes through the eye's ray, along which GTAO and the visibility bitmask step over
// the screen. What the two have in common: directions, noise, sample positions, and the cosine-weighted integral.
// Source: Jimenez et al. 2016, "Practical real-time strategies for accurate indirect occlusion" (GTAO), section 4;
//         XeGTAO 1.30 for noise and sample positions.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/lanes/arc_cosine.h"
#include "ssao/inputs/noise_tile.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"

namespace crevice {

// Samples a texel as slices and steps: 4, 8, 18 and 54 are XeGTAO's presets low (1x2), medium (2x2), high (3x3) and ultra
// (9x3).
struct SlicePlan {
    int slices, steps;  // steps to each side
};
inline SlicePlan slice_plan(int samples) {
    const int steps = samples < 18 ? 2 : 3;
    return {samples / (2 * steps), steps};
}
// Throws UsageError unless `samples` is a whole number of slices, up to 32 of them.
void validate_slice_samples(int samples);

// The directions of a texel's slices on the screen, unit, before its turn.
std::vector<glm::vec2> slice_directions(int slices);

// The number of cell (x, y) along a Hilbert curve through 64 x 64 cells.
int hilbert_index(int x, int y);

// How a texel's slices are turned and its steps shifted: the R2 sequence of Roberts (2018) along a Hilbert curve, as in
// XeGTAO. Each seed is another stretch of the sequence.
struct SliceNoise {
    NoiseTile cosine, sine;  // of the turn, between two slices
    NoiseTile step;          // [0, 1)

    SliceNoise(std::uint32_t seed, int slices);
};

// One slice through a group of texels. Its plane holds v, towards the eye, and t, to its positive side.
template <class F>
struct Slice {
    F x, y;            // direction on the screen, y down, unit
    Vec3<F> v, t;      // view space, unit, orthogonal
    F length;          // of the normal's part in the plane, [0, 1]
    F inverse_length;  // 1 where the length is 0
    F cosine, sine;    // of the angle gamma from v to that part, towards t; cosine >= 0
    F gamma;           // radians
    F open;            // accessibility of the whole slice where nothing occludes, over `length`
};

template <class F>
CREVICE_INLINE Slice<F> slice_of(const TexelPoint<F>& texel, const AoInputs& inputs, F x, F y) {
    Slice<F> slice;
    slice.x = x;
    slice.y = F(0) - y;
    const F zero(0), one(1);
    slice.v = inputs.rays.perspective ? towards_eye(texel) : Vec3<F>{zero, zero, F(-1)};
    const F along_v = x * slice.v.x + y * slice.v.y;
    slice.t = normalize_or<F>(Vec3<F>{x, y, zero} - along_v * slice.v, {one, zero, zero});
    const F n_t = dot(texel.n, slice.t), n_v = dot(texel.n, slice.v);
    // A normal that points away from the eye is taken to lie at the edge of what can be seen.
    const F towards = max_of(n_v, zero);
    slice.length = square_root(n_t * n_t + towards * towards);
    const auto usable = slice.length > F(1e-6f);
    const F inverse = one / select(usable, slice.length, one);
    slice.length = select(usable, slice.length, zero);
    slice.inverse_length = inverse;
    slice.cosine = select(usable, towards * inverse, one);
    slice.sine = select(usable, n_t * inverse, zero);
    const F angle = arc_cosine(slice.cosine);
    slice.gamma = select(slice.sine < zero, zero - angle, angle);
    slice.open = slice.cosine + slice.gamma * slice.sine;
    return slice;
}

// The cosine of the angle from v at which something at `delta` from the point stands in the slice. A pixel lies beside the
// slice's plane by up to half a pixel: it is moved into it along the surface, keeping its height above that. Taken as it
// is seen, an open plane seen at a slant would rise above itself. `side` is 1 or -1; what comes to lie on the other side
// is behind the point: -1.
template <class F>
CREVICE_INLINE F horizon_cosine(const Slice<F>& slice, float side, Vec3<F> n, Vec3<F> delta) {
    const Vec3<F> axis = cross(slice.t, slice.v);
    const F beside = dot(axis, n) * dot(axis, delta) * slice.inverse_length;
    const F across = dot(slice.t, delta) + slice.sine * beside,
            towards = dot(slice.v, delta) + slice.cosine * beside;
    const F squared = across * across + towards * towards;
    return select(F(side) * across > F(0), towards / square_root(select(squared > F(0), squared, F(1))),
                  F(-1));
}

// What a slice loses, over its length, when everything beyond an angle from v on its positive side is closed: the
// paper's integral (equation 7) from that angle to the horizon of the open plane. `c` is the cosine of the angle, at
// least that of the open horizon, which is -sine. For the negative side give -gamma and -sine.
template <class F>
CREVICE_INLINE F closed_beyond(F c, F cosine, F sine, F gamma) {
    const F h = arc_cosine(c), s = square_root(max_of(F(1) - c * c, F(0)));
    const F of_double_angle = (F(2) * c * c - F(1)) * cosine + F(2) * c * s * sine;
    const F loss =
        F(0.25f) * (cosine + of_double_angle + F(2) * (gamma + F(static_cast<float>(kPi / 2)) - h) * sine);
    return select(c > F(0) - sine, max_of(loss, F(0)), F(0));
}

// A direction in a slice's plane, on one side of v.
template <class F>
struct SliceVector {
    F along_v, along_t;  // on the negative side along -t
};

// The directions that closed_beyond() sums up, each as a vector with the same weight: where the closed part lies. Their
// integrals are those of cos(a - gamma) sin(a) cos(a) and cos(a - gamma) sin^2(a).
template <class F>
CREVICE_INLINE SliceVector<F> closed_directions(F c, F cosine, F sine) {
    const F s = square_root(max_of(F(1) - c * c, F(0)));
    const F c3 = c * c * c, s3 = s * s * s, cosine3 = cosine * cosine * cosine, sine3 = sine * sine * sine;
    const F third(1.0f / 3), closed_from_v = cosine3 - s3;
    const F along_v = third * (cosine * (c3 + sine3) + sine * closed_from_v),
            along_t = third * (cosine * closed_from_v + sine * (F(3) * (c + sine) - c3 - sine3));
    const auto closes = c > F(0) - sine;
    return {select(closes, along_v, F(0)), select(closes, along_t, F(0))};
}

// The power of XeGTAO (its sample distribution power) with which steps lie denser near the texel.
inline constexpr float kStepPower = 2;

// How far along its slice a step lies, pixels: evenly shifted parts of the radius to some power, and always on another
// pixel.
template <class F>
CREVICE_INLINE F step_distance_px(int slice, int step, SlicePlan plan, F noise, F radius_px,
                                  float step_power = kStepPower) {
    constexpr float kGolden = 0.6180339887498948482f, kNextPixel = 1.3f;
    const F shifted = noise + F(static_cast<float>(slice + step * plan.steps) * kGolden);
    const F part = (F(static_cast<float>(step)) + shifted - F(to_float(floor_to_int(shifted)))) /
                   F(static_cast<float>(plan.steps));
    const F along = step_power == 2 ? part * part : power(part, F(step_power));
    return along * radius_px + F(kNextPixel);
}

}  // namespace crevice
