// Elementary functions from + - * / and square roots only: the same bits on every machine, at every width.
// libm gives neither. Each function states its error, measured by tests/rasterizer/lanes/approx_math_test.cpp.
#pragma once

#include "rasterizer/lanes/wide.h"

namespace crevice {

inline constexpr double kPi = 3.14159265358979323846;

// In double, whose exponent is that of the nearest float; kernels in double stay within the range of floats.
CREVICE_INLINE std::int32_t float_bits(double a) { return float_bits(static_cast<float>(a)); }
// a / 2^exponent, for the bits of a.
template <class F>
CREVICE_INLINE F over_power_of_two(F a, Int<F> bits, Int<F> exponent) {
    if constexpr (std::is_same_v<F, double>) {
        return a * to_double(float_from_bits((127 - exponent) << 23));
    } else {
        return float_from_bits(bits - (exponent << 23));
    }
}

// log2(a) for normal a > 0; absolute error below 2e-7 for a in [1/2, 2], else relative error below 2e-7.
// log2(1) is 0. a is split into m * 2^e with m in [sqrt(1/2), sqrt(2)); log2(m) is the odd series of
// atanh((m-1)/(m+1)).
template <class F>
CREVICE_INLINE F log2_of(F a) {
    const Int<F> bits = float_bits(a);
    const Int<F> sqrt_half_bits(0x3f3504f3);
    const Int<F> exponent = (bits - sqrt_half_bits) >> 23;
    const F m = over_power_of_two(a, bits, exponent);
    const F t = (m - F(1)) / (m + F(1));
    const F t2 = t * t;
    F series = F(2.885390082f / 11);
    series = series * t2 + F(2.885390082f / 9);
    series = series * t2 + F(2.885390082f / 7);
    series = series * t2 + F(2.885390082f / 5);
    series = series * t2 + F(2.885390082f / 3);
    series = series * t2 + F(2.885390082f);
    return F(to_float(exponent)) + t * series;
}

// 2^a with a clamped to [-126, 126]; relative error below 2e-7. exp2_of(0) is 1.
template <class F>
CREVICE_INLINE F exp2_of(F a) {
    const F clamped = min_of(max_of(a, F(-126)), F(126));
    const Int<F> whole = floor_to_int(clamped + F(0.5f));
    const F x = (clamped - F(to_float(whole))) * F(0.693147181f);
    F series = F(1.0f / 5040);
    series = series * x + F(1.0f / 720);
    series = series * x + F(1.0f / 120);
    series = series * x + F(1.0f / 24);
    series = series * x + F(1.0f / 6);
    series = series * x + F(0.5f);
    series = series * x + F(1);
    series = series * x + F(1);
    return series * float_from_bits((whole + Int<F>(127)) << 23);
}

// a^b for a >= 0; 0 for a below the smallest normal number, 1 for a = 1. Relative error below 2e-7 * (1 + |b
// log2 a|).
template <class F>
CREVICE_INLINE F power(F a, F b) {
    const auto positive = a >= F(1.17549435e-38f);
    return select(positive, exp2_of(b * log2_of(select(positive, a, F(1)))), F(0));
}

// Linear light in [0,1] to the sRGB transfer curve (IEC 61966-2-1), and back.
template <class F>
CREVICE_INLINE F srgb_from_linear(F linear) {
    const F curve = F(1.055f) * power(linear, F(1 / 2.4f)) - F(0.055f);
    return select(linear <= F(0.0031308f), F(12.92f) * linear, curve);
}
template <class F>
CREVICE_INLINE F linear_from_srgb(F encoded) {
    const F curve = power((encoded + F(0.055f)) / F(1.055f), F(2.4f));
    return select(encoded <= F(0.04045f), encoded / F(12.92f), curve);
}

// sin and cos of an angle in radians, |angle| < 1e5; absolute error below 1e-15. Reduced to [-pi/4, pi/4],
// Taylor series.
struct SineCosine {
    double sine, cosine;
};
inline SineCosine sine_cosine(double angle_rad) {
    const double quarter = angle_rad * (2 / kPi);
    const long quadrant = static_cast<long>(quarter + (quarter < 0 ? -0.5 : 0.5));
    // pi/2 in two parts, so that the reduction loses nothing.
    const double x = (angle_rad - static_cast<double>(quadrant) * 1.57079632673412561417) -
                     static_cast<double>(quadrant) * 6.07710050650619224932e-11;
    const double x2 = x * x;
    double s = 0, c = 0;
    for (int k = 17; k >= 3; k -= 2) s = (1 + s) * -x2 / (k * (k - 1));
    for (int k = 18; k >= 2; k -= 2) c = (1 + c) * -x2 / (k * (k - 1));
    const double sine = x * (1 + s), cosine = 1 + c;
    switch (quadrant & 3) {
        case 0: return {sine, cosine};
        case 1: return {cosine, -sine};
        case 2: return {-sine, -cosine};
        default: return {-cosine, sine};
    }
}

inline double tangent(double angle_rad) {
    const SineCosine at = sine_cosine(angle_rad);
    return at.sine / at.cosine;
}

constexpr double radians(double degrees) { return degrees * (kPi / 180); }

}  // namespace crevice
