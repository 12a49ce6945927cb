// Directions over a hemisphere, as many as asked for, different at every point and the same on every machine.
// Source: scrambled (0,2)-sequence: Sobol' 1967 in base 2, scrambled after Owen 1995 by the hash of Burley
//         2020, "Practical hash-based Owen scrambling", JCGT 9(4), with Vegdahl's constants; tangent frame:
//         Duff et al. 2017, "Building an orthonormal basis, revisited", JCGT 6(1).
// Out:    unit vectors (to 1e-6) of the hemisphere around +z
// Cost:   about 70 operations a direction, half of them integers.
#pragma once

#include <cstdint>
#include <vector>

#include "rasterizer/base/hash.h"
#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/lanes/vec3.h"

namespace crevice {

enum class RayWeight {
    cosine,   // denser towards the normal: the mean is what a white sky would light
    uniform,  // the same everywhere, as in Luna
};

enum class RaySequence {
    sobol,        // scrambled low-discrepancy points: the error falls faster than 1 / sqrt(rays)
    independent,  // random numbers, as the tutorials take them: error ~ 1 / sqrt(rays)
};

// Values are made in groups of this many, whatever the lanes.
inline constexpr int kPointGroup = 8;

// A random permutation of all 32-bit numbers in which bit i depends on the bits below it alone: Owen
// scrambling of numbers whose bits are reversed.
CREVICE_INLINE std::uint32_t scrambled_bits(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// Every bit depends on every bit of x: Wellons 2018, "lowbias32".
CREVICE_INLINE std::uint32_t mixed_bits(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

CREVICE_INLINE std::uint32_t reversed_bits(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
    x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
    return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

// Points of the unit square that directions are made of: the same number of them for each pair of seed and
// stream, different pairs independent of each other.
class SquarePoints {
 public:
    SquarePoints(int count, RaySequence sequence);  // count >= 1

    int count() const { return count_; }

    // Fills u and v with numbers in [0, 1); both have room for round_up(count(), kPointGroup), all of which
    // are filled.
    CREVICE_INLINE void fill(std::uint32_t seed, std::uint32_t stream, float* u, float* v) const {
        const std::uint32_t seed_u = scramble_seed(seed, stream, 0), seed_v = scramble_seed(seed, stream, 1);
        for (std::uint32_t first = 0; first < second_.size(); first += kPointGroup) {
            // Loops of a known length over plain arrays: compilers make vectors of them.
            if (sequence_ == RaySequence::sobol) {
                for (std::uint32_t i = first; i < first + kPointGroup; ++i) {
                    u[i] = unit_number(reversed_bits(scrambled_bits(i, seed_u)));
                    v[i] = unit_number(reversed_bits(scrambled_bits(second_[i], seed_v)));
                }
            } else {
                for (std::uint32_t i = first; i < first + kPointGroup; ++i) {
                    u[i] = unit_number(mixed_bits(mixed_bits(i) + seed_u));
                    v[i] = unit_number(mixed_bits(mixed_bits(i) + seed_v));
                }
            }
        }
    }

 private:
    static std::uint32_t scramble_seed(std::uint32_t seed, std::uint32_t stream, std::uint32_t coordinate);

    int count_;
    RaySequence sequence_;
    // Sobol's second coordinates, bits reversed (the first are 0, 1, 2 ...).
    std::vector<std::uint32_t> second_;
};

// sin and cos of 2 pi u for u in [0, 1]; absolute error below 2e-7.
template <class F>
struct SineCosineOf {
    F sine, cosine;
};
template <class F>
CREVICE_INLINE SineCosineOf<F> sine_cosine_of_turns(F u) {
    // The angle less the nearest multiple of a quarter turn, in [-pi/4, pi/4]: Taylor series.
    const Int<F> quarter = floor_to_int(F(4) * u + F(0.5f));
    const F x = (u - F(0.25f) * F(to_float(quarter))) * F(static_cast<float>(2 * kPi)), x2 = x * x;
    const F sine = x + x * x2 * (F(-1.0f / 6) + x2 * (F(1.0f / 120) + x2 * F(-1.0f / 5040)));
    const F cosine =
        F(1) + x2 * (F(-0.5f) + x2 * (F(1.0f / 24) + x2 * (F(-1.0f / 720) + x2 * F(1.0f / 40320))));
    const auto odd = (quarter & Int<F>(1)) == Int<F>(1);
    const auto sine_negative = (quarter & Int<F>(2)) == Int<F>(2);
    const auto cosine_negative = ((quarter + Int<F>(1)) & Int<F>(2)) == Int<F>(2);
    const F s = select(odd, cosine, sine), c = select(odd, sine, cosine);
    return {select(sine_negative, -s, s), select(cosine_negative, -c, c)};
}

// The direction that a point of the square becomes: v the angle around z, u how far from it.
template <class F>
CREVICE_INLINE Vec3<F> hemisphere_direction(RayWeight weight, F u, F v) {
    // Cosine: z^2 is spread evenly over [0, 1] (Malley's method); uniform: z is.
    const bool cosine = weight == RayWeight::cosine;
    const F z = cosine ? square_root(F(1) - u) : F(1) - u;
    const F from_axis = cosine ? square_root(u) : square_root(u * (F(2) - u));
    const SineCosineOf<F> around = sine_cosine_of_turns(v);
    return {from_axis * around.cosine, from_axis * around.sine, z};
}

// Two unit vectors that make a frame with the unit vector n, whichever it is.
struct TangentFrame {
    glm::vec3 tangent, bitangent, normal;
};
inline TangentFrame tangent_frame(glm::vec3 n) {
    const float sign = n.z < 0 ? -1.0f : 1.0f, a = -1 / (sign + n.z), b = n.x * n.y * a;
    return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

template <class F>
CREVICE_INLINE Vec3<F> in_frame(const TangentFrame& frame, Vec3<F> d) {
    return d.x * spread<F>(frame.tangent) + d.y * spread<F>(frame.bitangent) + d.z * spread<F>(frame.normal);
}

}  // namespace crevice
