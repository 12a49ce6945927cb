// Rays over the screen that HBAO and HBAO+ step along: directions all around a texel, turned and shifted from one texel
// to the next; and what a pixel beside such a ray stands for.
// Source: Bavoil & Sainz 2008, "Image-space horizon-based ambient occlusion": 4 x 4 turns and shifts, then a blur.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "rasterizer/lanes/vec3.h"
#include "ssao/inputs/noise_tile.h"

namespace crevice {

inline constexpr int kMostSteps = 32, kMostDirections = 64;

// Throws UsageError unless `samples` is a whole number of directions of `steps` steps each.
void validate_screen_rays(int samples, int steps);

// Unit vectors around the circle, y up, the first one to the right.
std::vector<glm::vec2> even_directions(int count);

// Of 4 x 4 texels each has another turn between two directions and another shift of its first step.
struct RayNoise {
    NoiseTile cosine, sine;  // of the turn
    NoiseTile shift;         // [0, 1)

    RayNoise(std::uint32_t seed, int directions);
};

// How far from the texel a step lies: evenly spaced, at least a pixel, the last one short of the radius.
template <class F>
CREVICE_INLINE F ray_distance_px(int step, int steps, F shift, F radius_px) {
    const F spacing = radius_px / F(static_cast<float>(steps + 1));
    return (F(static_cast<float>(step)) + shift) * spacing + F(1);
}

// The cosine of the angle from v, towards the eye, of a unit direction d, as if it lay in a plane through v where the
// normal n has the cosine and sine of an angle from v. A pixel lies beside its ray by up to half of one, where a tilted
// plane stands higher or lower: d keeps the angle that it has above the plane beneath it.
template <class F>
CREVICE_INLINE F cosine_beside(Vec3<F> d, Vec3<F> n, Vec3<F> v, F cosine, F sine) {
    const F d_v = dot(d, v), n_v = dot(n, v), d_n = dot(d, n);
    const F squared = F(1) - d_v * d_v;
    const auto beside_v = squared > F(1e-3f);
    const F d_e = square_root(select(beside_v, squared, F(1)));
    const F n_e = (d_n - n_v * d_v) / d_e;  // e is the direction of d across v
    const F length = n_e * n_e + n_v * n_v;
    const auto usable = beside_v & (n_v > F(0)) & (length > F(1e-6f));
    const F inverse = F(1) / square_root(select(usable, length, F(1)));
    const F sine_above = d_n * inverse, cosine_above = (n_v * d_e - n_e * d_v) * inverse;
    return select(usable, sine_above * cosine - cosine_above * sine, d_v);
}

}  // namespace crevice
