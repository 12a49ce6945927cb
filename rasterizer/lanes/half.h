// 16-bit floats, as the tutorials' R16G16B16A16_FLOAT targets store them: bits and values, for every lane
// type.
#pragma once

#include "rasterizer/lanes/wide.h"

namespace crevice {

enum class HalfRounding {
    toward_zero,  // what D3D demands (D3D11.3 functional spec 3.2.2): too large becomes 65504, never infinity
    nearest_even,  // what IEEE 754 and most C++ conversions do: 65520 and above become infinity
};

// The 16 bits of a, in the low half of the result. NaN stays a NaN.
template <class F>
CREVICE_INLINE Int<F> half_bits(F a, HalfRounding rounding) {
    using I = Int<F>;
    const I bits = float_bits(a);
    const I sign = (bits >> 16) & I(0x8000);
    const I magnitude = bits & I(0x7fffffff);
    const bool even = rounding == HalfRounding::nearest_even;

    // Normal halves: re-bias the exponent by 127 - 15 and drop 13 bits of the fraction.
    const I last_bit = (magnitude >> 13) & I(1);
    const I rounded = even ? magnitude + I(0xfff) + last_bit : magnitude;
    const I largest = I(even ? 0x7c00 : 0x7bff);
    const I finite =
        select(magnitude >= I(0x47800000), largest, min_of((rounded - I(0x38000000)) >> 13, largest));

    // Subnormal halves count steps of 2^-24; the product is exact.
    const F steps = float_from_bits(select(magnitude < I(0x38800000), magnitude, I(0))) * F(16777216.0f);
    const I subnormal = even ? round_half_even(steps) : to_int(steps);

    I result = select(magnitude < I(0x38800000), subnormal, finite);
    result = select(magnitude == I(0x7f800000), I(0x7c00), result);
    result = select(magnitude > I(0x7f800000), I(0x7e00), result);
    return result | sign;
}

template <class F>
CREVICE_INLINE F float_from_half_bits(Int<F> half) {
    using I = Int<F>;
    const I sign = (half & I(0x8000)) << 16;
    const I magnitude = half & I(0x7fff);
    const I subnormal = float_bits(F(to_float(magnitude)) * F(1 / 16777216.0f));
    const I normal = (magnitude << 13) + I(0x38000000);
    const I special = (magnitude << 13) | I(0x7f800000);
    I bits = select(magnitude < I(0x0400), subnormal, normal);
    bits = select(magnitude >= I(0x7c00), special, bits);
    return float_from_bits(bits | sign);
}

// How a floating-point buffer stores its values.
enum class BufferFormat { float32, float16_toward_zero, float16_nearest_even };

// a as it comes back from a buffer of this format.
template <class F>
CREVICE_INLINE F stored_as(F a, BufferFormat format) {
    switch (format) {
        case BufferFormat::float32: return a;
        case BufferFormat::float16_toward_zero:
            return float_from_half_bits<F>(half_bits(a, HalfRounding::toward_zero));
        case BufferFormat::float16_nearest_even:
            return float_from_half_bits<F>(half_bits(a, HalfRounding::nearest_even));
    }
    return a;
}

}  // namespace crevice
