// The functions of wide.h for plain floats: one pixel, to step through.
#pragma once

#include <cstdint>

#include "rasterizer/lanes/wide_types.h"

namespace crevice {

CREVICE_INLINE bool any(bool m) { return m; }
CREVICE_INLINE bool all(bool m) { return m; }
// Bit i is set where lane i is.
CREVICE_INLINE unsigned lane_bits(bool m) { return m ? 1u : 0u; }
CREVICE_INLINE std::int32_t largest_of(std::int32_t a) { return a; }
CREVICE_INLINE float select(bool m, float a, float b) { return m ? a : b; }
CREVICE_INLINE double select(bool m, double a, double b) { return m ? a : b; }
CREVICE_INLINE std::int32_t select(bool m, std::int32_t a, std::int32_t b) { return m ? a : b; }
CREVICE_INLINE float square_root(float a) { return __builtin_sqrtf(a); }
CREVICE_INLINE double square_root(double a) { return __builtin_sqrt(a); }
// Toward zero. Defined for |a| < 2^31.
CREVICE_INLINE std::int32_t to_int(float a) { return static_cast<std::int32_t>(a); }
CREVICE_INLINE std::int32_t to_int(double a) { return static_cast<std::int32_t>(a); }
CREVICE_INLINE float to_float(std::int32_t a) { return static_cast<float>(a); }
CREVICE_INLINE float to_float(double a) { return static_cast<float>(a); }
CREVICE_INLINE double to_double(float a) { return static_cast<double>(a); }
CREVICE_INLINE double to_double(std::int32_t a) { return static_cast<double>(a); }
// Not std::bit_cast: in Debug builds that is a call, and a Wide would change its calling convention.
CREVICE_INLINE std::int32_t float_bits(float a) { return __builtin_bit_cast(std::int32_t, a); }
CREVICE_INLINE std::int32_t upper_bits(double a) {
    return static_cast<std::int32_t>(__builtin_bit_cast(std::int64_t, a) >> 32);
}
CREVICE_INLINE float float_from_bits(std::int32_t a) { return __builtin_bit_cast(float, a); }
CREVICE_INLINE float gather(const float* base, std::int32_t index) { return base[index]; }
CREVICE_INLINE std::int32_t gather(const std::int32_t* base, std::int32_t index) { return base[index]; }
template <class F>
requires(kLanes<F> == 1) CREVICE_INLINE F load(const float* at) { return static_cast<F>(*at); }
template <class F>
requires(kLanes<F> == 1) CREVICE_INLINE std::int32_t load(const std::int32_t* at) { return *at; }
CREVICE_INLINE void store(float* at, float a) { *at = a; }
CREVICE_INLINE void store(std::int32_t* at, std::int32_t a) { *at = a; }
CREVICE_INLINE void store(double* at, double a) { *at = a; }
// a * b - c * d modulo 2^32: exact where the difference fits, also where the products do not.
CREVICE_INLINE std::int32_t wrapped_difference(std::int32_t a, std::int32_t b, std::int32_t c,
                                               std::int32_t d) {
    using Word = std::uint32_t;
    return static_cast<std::int32_t>(static_cast<Word>(a) * static_cast<Word>(b) -
                                     static_cast<Word>(c) * static_cast<Word>(d));
}
// 0, 1, 2 ... one a lane.
template <class F>
requires(kLanes<F> == 1) CREVICE_INLINE std::int32_t lane_index() { return 0; }

}  // namespace crevice
