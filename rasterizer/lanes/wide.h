// The functions that kernels are written with, for one pixel or several.
//
// A kernel is written once as `template <class F>` and runs with F = float (one pixel, to step through),
// Wide<4>, Wide<8> or Wide<16> (as many pixels as the register holds, to be fast) or double (truth for rounding error).
// The functions below exist under the same names for all of them. Every operation is the IEEE one lane by
// lane, so the lane count never changes a bit.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "rasterizer/lanes/one_lane.h"
#include "rasterizer/lanes/wide_halves.h"

namespace crevice {

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
template <int N>
CREVICE_INLINE unsigned lane_bits(WideMask<N> m) {
    return lane_bits(WideMask<N / 2>{low_half(m.v)}) | lane_bits(WideMask<N / 2>{high_half(m.v)}) << (N / 2);
}
// More are joined to one 128-bit vector: the shortest that both compilers find. WebAssembly has an instruction for it;
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
template <int N>
CREVICE_INLINE bool any(WideMask<N> m) {
    return any(WideMask<N / 2>{low_half(m.v) | high_half(m.v)});
}
template <int N>
CREVICE_INLINE bool all(WideMask<N> m) {
    return !any(!m);
}
// By halves down to four.
template <int N>
CREVICE_INLINE std::int32_t largest_of(WideInt<N> a) {
    if constexpr (N > 4) {
        const WideInt<N / 2> low(low_half(a.v)), high(high_half(a.v));
        return largest_of(select(low > high, low, high));
    } else {
        std::int32_t largest = a.v[0];
        CREVICE_UNROLLED
        for (int i = 1; i < N; ++i) largest = a.v[i] > largest ? a.v[i] : largest;
        return largest;
    }
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
    if constexpr (kElements<V> == 16) {
        return __builtin_shufflevector(m, m, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7);
    } else if constexpr (kElements<V> == 8) {
        return __builtin_shufflevector(m, m, 0, 0, 1, 1, 2, 2, 3, 3);
    } else {
        return __builtin_shufflevector(m, m, 0, 0, 1, 1);
    }
}
template <class V>
CREVICE_INLINE V upper_twice(V m) {
    if constexpr (kElements<V> == 16) {
        return __builtin_shufflevector(m, m, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13, 14, 14, 15, 15);
    } else if constexpr (kElements<V> == 8) {
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
template <class T>
CREVICE_INLINE WideOf<T, 16> gather(const T* base, WideInt<16> index) {
    const auto half = [&](auto eight) __attribute__((always_inline)) { return gather(base, WideInt<8>(eight)).v; };
    return WideOf<T, 16>(joined(half(low_half(index.v)), half(high_half(index.v))));
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
    const auto counted = []<int... i>(std::integer_sequence<int, i...>)
        __attribute__((always_inline)) { return Int<F>(typename Int<F>::V{i...}); };
    return counted(std::make_integer_sequence<int, kLanes<F>>{});
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
