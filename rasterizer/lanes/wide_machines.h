// Functions of wide.h that one kind of machine does in fewer instructions than the compiler finds by itself. They
// have the names and the bits of the general ones and are called instead of them; wide.h includes this file.
#pragma once

#include "rasterizer/lanes/wide.h"

namespace crevice {

#if defined(__aarch64__)

// GCC 12 converts between doubles and 32-bit numbers one by one, but to and from 64-bit numbers two at a time.
CREVICE_INLINE WideInt<4> to_int(WideDouble<4> a) {
    using Half = VectorOf<std::int64_t, 2>::type;
    return WideInt<4>(even_words(__builtin_convertvector(low_half(a.v), Half),
                                 __builtin_convertvector(high_half(a.v), Half)));
}
CREVICE_INLINE WideDouble<4> to_double(WideInt<4> a) {
    using Half = VectorOf<double, 2>::type;
    const auto words = __builtin_convertvector(a.v, VectorOf<std::int64_t, 4>::type);
    return WideDouble<4>(joined(__builtin_convertvector(low_half(words), Half),
                                __builtin_convertvector(high_half(words), Half)));
}

#elif defined(__wasm_simd128__)

// To doubles of which 1.5 * 2^52 is added a whole number is the lower word, as two's complement. Saturating
// conversion, the only one that WebAssembly has, takes longer.
CREVICE_INLINE WideInt<4> to_int(WideDouble<4> a) {
    constexpr double kShift = 6755399441055744.0;
    return WideInt<4>(even_words(__builtin_wasm_trunc_f64x2(low_half(a.v)) + kShift,
                                 __builtin_wasm_trunc_f64x2(high_half(a.v)) + kShift));
}
CREVICE_INLINE Wide<4> to_float(WideDouble<4> a) {
    const auto half = [](auto two) __attribute__((always_inline)) {
        auto floats = __builtin_convertvector(joined(two, decltype(two){}), Wide<4>::V);
        // Hidden from the optimizer, which else makes one conversion of both halves: there is no such instruction.
        asm("" : "+r"(floats));
        return floats;
    };
    return Wide<4>(__builtin_shufflevector(half(low_half(a.v)), half(high_half(a.v)), 0, 1, 4, 5));
}
CREVICE_INLINE WideInt<4> floor_to_int(Wide<4> a) { return to_int(Wide<4>(__builtin_wasm_floor_f32x4(a.v))); }

// pmax(b, a) is b < a ? a : b, and pmin(b, a) is a < b ? a : b.
CREVICE_INLINE Wide<4> max_of(Wide<4> a, Wide<4> b) { return Wide<4>(__builtin_wasm_pmax_f32x4(b.v, a.v)); }
CREVICE_INLINE Wide<4> min_of(Wide<4> a, Wide<4> b) { return Wide<4>(__builtin_wasm_pmin_f32x4(b.v, a.v)); }
CREVICE_INLINE WideDouble<4> max_of(WideDouble<4> a, WideDouble<4> b) {
    return WideDouble<4>(joined(__builtin_wasm_pmax_f64x2(low_half(b.v), low_half(a.v)),
                                __builtin_wasm_pmax_f64x2(high_half(b.v), high_half(a.v))));
}
CREVICE_INLINE WideDouble<4> min_of(WideDouble<4> a, WideDouble<4> b) {
    return WideDouble<4>(joined(__builtin_wasm_pmin_f64x2(low_half(b.v), low_half(a.v)),
                                __builtin_wasm_pmin_f64x2(high_half(b.v), high_half(a.v))));
}

#elif defined(CREVICE_MASK_REGISTERS)

CREVICE_INLINE unsigned lane_bits(WideMask<16> m) { return m.bits; }
CREVICE_INLINE bool any(WideMask<16> m) { return m.bits != 0; }
CREVICE_INLINE Wide<16> select(WideMask<16> m, Wide<16> a, Wide<16> b) {
    return Wide<16>(__builtin_ia32_blendmps_512_mask(b.v, a.v, m.bits));
}
CREVICE_INLINE WideInt<16> select(WideMask<16> m, WideInt<16> a, WideInt<16> b) {
    return WideInt<16>(__builtin_ia32_blendmd_512_mask(b.v, a.v, m.bits));
}
CREVICE_INLINE WideDouble<16> select(WideMask<16> m, WideDouble<16> a, WideDouble<16> b) {
    return {__builtin_ia32_blendmpd_512_mask(b.low, a.low, static_cast<std::uint8_t>(m.bits)),
            __builtin_ia32_blendmpd_512_mask(b.high, a.high, static_cast<std::uint8_t>(m.bits >> 8))};
}
CREVICE_INLINE Wide<16> square_root(Wide<16> a) {
    return Wide<16>(__builtin_ia32_sqrtps512_mask(a.v, a.v, WideMask<16>::kAll, WideMask<16>::kRounding));
}

#endif

}  // namespace crevice
