// The functions that kernels are written with, for one pixel or several.
//
// A kernel is written once as `template <class F>` and runs with F = float (one pixel, to step through),
// Wide<4> or Wide<8> (as many pixels as the register holds, to be fast) or double (truth for rounding error).
// The functions below exist under the same names for all of them. Every operation is the IEEE one lane by
// lane, so the lane count never changes a bit.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "rasterizer/lanes/wide_halves.h"

namespace crevice {

// ---- one lane

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

// ---- N lanes

CREVICE_INLINE unsigned lane_bits(WideMask<4> m) {
#if defined(__SSE__)
    return static_cast<unsigned>(__builtin_ia32_movmskps(__builtin_bit_cast(VectorOf<float, 4>::type, m.v)));
#elif defined(__wasm_simd128__)
    return static_cast<unsigned>(__builtin_wasm_bitmask_i32x4(m.v));
#else
    const auto bits = m.v & VectorOf<std::int32_t, 4>::type{1, 2, 4, 8};
    return static_cast<unsigned>((bits[0] | bits[1]) | (bits[2] | bits[3]));
#endif
}
CREVICE_INLINE unsigned lane_bits(WideMask<8> m) {
    return lane_bits(WideMask<4>{low_half(m.v)}) | lane_bits(WideMask<4>{high_half(m.v)}) << 4;
}
// Eight are joined to one 128-bit vector: the shortest that both compilers find. WebAssembly has an instruction for it;
// without one for lane_bits it is two 64-bit words.
CREVICE_INLINE bool any(WideMask<4> m) {
#if defined(__wasm_simd128__)
    return __builtin_wasm_any_true_v128(m.v) != 0;
#elif defined(__SSE__)
    return lane_bits(m) != 0;
#else
    const auto words = __builtin_bit_cast(VectorOf<std::int64_t, 2>::type, m.v);
    return (words[0] | words[1]) != 0;
#endif
}
CREVICE_INLINE bool any(WideMask<8> m) { return any(WideMask<4>{low_half(m.v) | high_half(m.v)}); }
template <int N>
CREVICE_INLINE bool all(WideMask<N> m) {
    return !any(!m);
}
template <int N>
CREVICE_INLINE std::int32_t largest_of(WideInt<N> a) {
    std::int32_t largest = a.v[0];
    CREVICE_UNROLLED
    for (int i = 1; i < N; ++i) largest = a.v[i] > largest ? a.v[i] : largest;
    return largest;
}
template <int N>
CREVICE_INLINE WideInt<N> wrapped_difference(WideInt<N> a, WideInt<N> b, WideInt<N> c, WideInt<N> d) {
    using Words = typename VectorOf<std::uint32_t, N>::type;
    const auto words = [](WideInt<N> of) __attribute__((always_inline)) {
        return __builtin_bit_cast(Words, of.v);
    };
    return WideInt<N>(__builtin_bit_cast(typename WideInt<N>::V, words(a) * words(b) - words(c) * words(d)));
}
// The upper 32 bits of each: the sign comes first.
template <int N>
CREVICE_INLINE WideInt<N> upper_bits(WideDouble<N> a) {
    return WideInt<N>(odd_words(low_half(a), high_half(a)));
}
// The bits of a where those of m are set, else those of b. Written out, because a compiler that no longer knows that
// each element of m is all ones or all zeros compares it with zero first, of 64 bits one by one.
template <class M, class V>
CREVICE_INLINE V select_bits(M m, V a, V b) {
    return __builtin_bit_cast(V, (__builtin_bit_cast(M, a) & m) | (__builtin_bit_cast(M, b) & ~m));
}
// Each word of the lower half of a mask twice, and of the upper: masks as wide as doubles.
template <class V>
CREVICE_INLINE V lower_twice(V m) {
    if constexpr (kElements<V> == 8) {
        return __builtin_shufflevector(m, m, 0, 0, 1, 1, 2, 2, 3, 3);
    } else {
        return __builtin_shufflevector(m, m, 0, 0, 1, 1);
    }
}
template <class V>
CREVICE_INLINE V upper_twice(V m) {
    if constexpr (kElements<V> == 8) {
        return __builtin_shufflevector(m, m, 4, 4, 5, 5, 6, 6, 7, 7);
    } else {
        return __builtin_shufflevector(m, m, 2, 2, 3, 3);
    }
}
template <class T, int N>
CREVICE_INLINE WideOf<T, N> select(WideMask<N> m, WideOf<T, N> a, WideOf<T, N> b) {
    if constexpr (sizeof(T) == sizeof(std::int32_t)) {
        return WideOf<T, N>(m.v ? a.v : b.v);
    } else {
        return of_halves(select_bits(lower_twice(m.v), low_half(a), low_half(b)),
                         select_bits(upper_twice(m.v), high_half(a), high_half(b)));
    }
}
template <int N>
CREVICE_INLINE Wide<N> select(WideMask<N> m, float a, Wide<N> b) {
    return select(m, Wide<N>(a), b);
}
template <int N>
CREVICE_INLINE Wide<N> select(WideMask<N> m, Wide<N> a, float b) {
    return select(m, a, Wide<N>(b));
}
template <int N>
CREVICE_INLINE Wide<N> square_root(Wide<N> a) {
    Wide<N> r;
    CREVICE_UNROLLED
    for (int i = 0; i < N; ++i) r.v[i] = __builtin_sqrtf(a.v[i]);
    return r;
}
template <class T, int N>
CREVICE_INLINE WideInt<N> to_int(WideOf<T, N> a) {
    return WideInt<N>(__builtin_convertvector(a.v, typename WideInt<N>::V));
}
template <class T, int N>
CREVICE_INLINE Wide<N> to_float(WideOf<T, N> a) {
    return Wide<N>(__builtin_convertvector(a.v, typename Wide<N>::V));
}
template <class T, int N>
CREVICE_INLINE WideDouble<N> to_double(WideOf<T, N> a) {
    return WideDouble<N>(__builtin_convertvector(a.v, typename WideDouble<N>::V));
}
template <int N>
CREVICE_INLINE WideInt<N> float_bits(Wide<N> a) {
    return WideInt<N>(__builtin_bit_cast(typename WideInt<N>::V, a.v));
}
template <int N>
CREVICE_INLINE Wide<N> float_from_bits(WideInt<N> a) {
    return Wide<N>(__builtin_bit_cast(typename Wide<N>::V, a.v));
}
template <class T>
CREVICE_INLINE WideOf<T, 4> gather(const T* base, WideInt<4> index) {
    const typename WideOf<T, 4>::V v = {base[index.v[0]], base[index.v[1]], base[index.v[2]],
                                        base[index.v[3]]};
    return WideOf<T, 4>(v);
}
template <class T>
CREVICE_INLINE WideOf<T, 8> gather(const T* base, WideInt<8> index) {
    WideOf<T, 8> r;
    for (int i = 0; i < 8; ++i) r.v[i] = base[index.v[i]];
    return r;
}
template <class F, class T>
requires(kLanes<F> > 1) CREVICE_INLINE WideOf<T, kLanes<F>> load(const T* at) {
    WideOf<T, kLanes<F>> r;
    std::memcpy(&r.v, at, sizeof r.v);
    return r;
}
template <class T, int N>
CREVICE_INLINE void store(T* at, WideOf<T, N> a) {
    std::memcpy(at, &a.v, sizeof a.v);
}
template <class F>
requires(kLanes<F> > 1) CREVICE_INLINE Int<F> lane_index() {
    Int<F> r;
    CREVICE_UNROLLED
    for (int i = 0; i < kLanes<F>; ++i) r.v[i] = i;
    return r;
}

// ---- the same text for every lane type

// A NaN in the first place gives the second operand, so min_of(max_of(NaN, 0), 1) is 0; in the second place
// it stays.
template <class A>
CREVICE_INLINE A max_of(A a, A b) {
    return select(a > b, a, b);
}
template <class A>
CREVICE_INLINE A min_of(A a, A b) {
    return select(a < b, a, b);
}
// Of doubles without the way through a 32-bit mask.
template <int N>
CREVICE_INLINE WideDouble<N> max_of(WideDouble<N> a, WideDouble<N> b) {
    const auto larger = [](auto x, auto y) __attribute__((always_inline)) { return x > y ? x : y; };
    return of_halves(larger(low_half(a), low_half(b)), larger(high_half(a), high_half(b)));
}
template <int N>
CREVICE_INLINE WideDouble<N> min_of(WideDouble<N> a, WideDouble<N> b) {
    const auto smaller = [](auto x, auto y) __attribute__((always_inline)) { return x < y ? x : y; };
    return of_halves(smaller(low_half(a), low_half(b)), smaller(high_half(a), high_half(b)));
}
// a clamped to [0,1]; NaN becomes 0.
template <class F>
CREVICE_INLINE F saturate(F a) {
    return min_of(max_of(a, F(0)), F(1));
}
// -0 stays as it is.
template <class F>
CREVICE_INLINE F absolute(F a) {
    return max_of(F(0) - a, a);
}
// A whole number as F; for double without the rounding of a float.
template <class F>
CREVICE_INLINE F from_int(Int<F> a) {
    if constexpr (std::is_same_v<F, double>) {
        return to_double(a);
    } else {
        return to_float(a);
    }
}
// Largest whole number <= a, for |a| < 2^31. Zero or one is taken away, because a mask is -1 already: choosing between
// two numbers takes three instructions more.
template <class F>
CREVICE_INLINE Int<F> floor_to_int(F a) {
    const Int<F> whole = to_int(a);
    return whole - select(from_int<F>(whole) > a, Int<F>(1), Int<F>(0));
}
// Nearest whole number, ties to even, for |a| < 2^31.
template <class F>
CREVICE_INLINE Int<F> round_half_even(F a) {
    const Int<F> below = floor_to_int(a);
    const F fraction = a - from_int<F>(below);
    const auto odd = (below & Int<F>(1)) == Int<F>(1);
    const auto up = (fraction > F(0.5f)) | ((fraction == F(0.5f)) & odd);
    return below + select(up, Int<F>(1), Int<F>(0));
}
// a where t = 0, b where t = 1; between equal values exactly that value.
template <class F>
CREVICE_INLINE F mix(F a, F b, F t) {
    return a + t * (b - a);
}
template <class I>
CREVICE_INLINE I clamp_int(I a, I low, I high) {
    return min_of(max_of(a, low), high);
}

}  // namespace crevice

#include "rasterizer/lanes/wide_machines.h"
