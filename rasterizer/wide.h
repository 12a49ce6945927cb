// Eight pixels as one value: arithmetic, comparison, select and gather over the compiler's vector extensions.
//
// A kernel is written once as `template <class F>` and runs with F = float (one pixel, to step through),
// Wide<8> (eight pixels, to be fast) or double (truth for rounding error). The functions below exist under
// the same names for all three. Every operation is the IEEE one lane by lane, so the lane count never changes
// a bit.
//
// Everything that takes a Wide by value is CREVICE_INLINE: passed to a function that is not inlined, a Wide
// would change its calling convention with the instruction set. In gdb: `skip -gfi *wide.h`.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace crevice {

#define CREVICE_INLINE [[gnu::always_inline]] inline

// The native vector of N elements. A trait, because GCC 12 drops vector_size written inside a class template.
template <class T, int N>
struct VectorOf;
template <>
struct VectorOf<float, 8> {
    typedef float type __attribute__((vector_size(32)));
};
template <>
struct VectorOf<std::int32_t, 8> {
    typedef std::int32_t type __attribute__((vector_size(32)));
};
template <>
struct VectorOf<std::int64_t, 8> {
    typedef std::int64_t type __attribute__((vector_size(64)));
};
template <>
struct VectorOf<double, 8> {
    typedef double type __attribute__((vector_size(64)));
};

// Eight doubles are compared and selected four at a time: GCC 12 has no better for AVX2 than one at a time.
template <class V>
CREVICE_INLINE auto low_half(V v) {
    return __builtin_shufflevector(v, v, 0, 1, 2, 3);
}
template <class V>
CREVICE_INLINE auto high_half(V v) {
    return __builtin_shufflevector(v, v, 4, 5, 6, 7);
}

// One truth value a lane: all bits set, or none.
template <int N>
struct WideMask {
    using V = typename VectorOf<std::int32_t, N>::type;
    V v;

    CREVICE_INLINE WideMask operator&(WideMask o) const { return {v & o.v}; }
    CREVICE_INLINE WideMask operator|(WideMask o) const { return {v | o.v}; }
    CREVICE_INLINE WideMask operator!() const { return {~v}; }
    CREVICE_INLINE bool operator[](int lane) const { return v[lane] != 0; }
};

template <class T, int N>
struct WideOf {
    using V = typename VectorOf<T, N>::type;
    V v;

    CREVICE_INLINE WideOf() = default;
    // Lane by lane: GCC 12 makes one broadcast of this, and eight inserts of {scalar, scalar, ...}.
    CREVICE_INLINE WideOf(T scalar) {
        for (int i = 0; i < N; ++i) v[i] = scalar;
    }
    CREVICE_INLINE explicit WideOf(V vector) : v(vector) {}

    CREVICE_INLINE T operator[](int lane) const { return v[lane]; }
    CREVICE_INLINE friend WideOf operator+(WideOf a, WideOf b) { return WideOf(a.v + b.v); }
    CREVICE_INLINE friend WideOf operator-(WideOf a, WideOf b) { return WideOf(a.v - b.v); }
    CREVICE_INLINE friend WideOf operator*(WideOf a, WideOf b) { return WideOf(a.v * b.v); }
    CREVICE_INLINE friend WideOf operator/(WideOf a, WideOf b) { return WideOf(a.v / b.v); }
    CREVICE_INLINE friend WideOf operator-(WideOf a) { return WideOf(-a.v); }
    CREVICE_INLINE friend WideOf operator&(WideOf a, WideOf b) { return WideOf(a.v & b.v); }
    CREVICE_INLINE friend WideOf operator|(WideOf a, WideOf b) { return WideOf(a.v | b.v); }
    CREVICE_INLINE friend WideOf operator<<(WideOf a, int bits) { return WideOf(a.v << bits); }
    CREVICE_INLINE friend WideOf operator>>(WideOf a, int bits) { return WideOf(a.v >> bits); }
    CREVICE_INLINE friend WideMask<N> operator<(WideOf a, WideOf b) {
        return compare(a, b, [](auto x, auto y) __attribute__((always_inline)) { return x < y; });
    }
    CREVICE_INLINE friend WideMask<N> operator<=(WideOf a, WideOf b) {
        return compare(a, b, [](auto x, auto y) __attribute__((always_inline)) { return x <= y; });
    }
    CREVICE_INLINE friend WideMask<N> operator>(WideOf a, WideOf b) {
        return compare(a, b, [](auto x, auto y) __attribute__((always_inline)) { return x > y; });
    }
    CREVICE_INLINE friend WideMask<N> operator>=(WideOf a, WideOf b) {
        return compare(a, b, [](auto x, auto y) __attribute__((always_inline)) { return x >= y; });
    }
    CREVICE_INLINE friend WideMask<N> operator==(WideOf a, WideOf b) {
        return compare(a, b, [](auto x, auto y) __attribute__((always_inline)) { return x == y; });
    }
    CREVICE_INLINE friend WideMask<N> operator!=(WideOf a, WideOf b) {
        return compare(a, b, [](auto x, auto y) __attribute__((always_inline)) { return x != y; });
    }

   private:
    template <class Comparison>
    CREVICE_INLINE static WideMask<N> compare(WideOf a, WideOf b, Comparison holds) {
        if constexpr (sizeof(T) == sizeof(std::int32_t)) {
            return {holds(a.v, b.v)};
        } else {
            typedef std::int32_t Half __attribute__((vector_size(16)));
            const Half low = __builtin_convertvector(holds(low_half(a.v), low_half(b.v)), Half),
                       high = __builtin_convertvector(holds(high_half(a.v), high_half(b.v)), Half);
            return {__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7)};
        }
    }
};

template <int N>
using Wide = WideOf<float, N>;
template <int N>
using WideInt = WideOf<std::int32_t, N>;
template <int N>
using WideDouble = WideOf<double, N>;

// The types that go with a lane type F: its integer, its boolean, its double, and how many pixels it holds.
template <class F>
struct LaneTypes {
    using Int = std::int32_t;
    using Double = double;
    using Mask = bool;
    static constexpr int kLanes = 1;
};
template <int N>
struct LaneTypes<Wide<N>> {
    using Int = WideInt<N>;
    using Double = WideDouble<N>;
    using Mask = WideMask<N>;
    static constexpr int kLanes = N;
};
template <class F>
using Int = typename LaneTypes<F>::Int;
template <class F>
using Double = typename LaneTypes<F>::Double;
template <class F>
using Mask = typename LaneTypes<F>::Mask;
template <class F>
inline constexpr int kLanes = LaneTypes<F>::kLanes;

// ---- one lane

CREVICE_INLINE bool any(bool m) { return m; }
CREVICE_INLINE std::int32_t largest_of(std::int32_t a) { return a; }
CREVICE_INLINE bool all(bool m) { return m; }
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
    requires(kLanes<F> == 1)
CREVICE_INLINE F load(const float* at) {
    return static_cast<F>(*at);
}
template <class F>
    requires(kLanes<F> == 1)
CREVICE_INLINE std::int32_t load(const std::int32_t* at) {
    return *at;
}
CREVICE_INLINE void store(float* at, float a) { *at = a; }
CREVICE_INLINE void store(std::int32_t* at, std::int32_t a) { *at = a; }
CREVICE_INLINE void store(double* at, double a) { *at = a; }
// 0, 1, 2 ... one a lane.
template <class F>
    requires(kLanes<F> == 1)
CREVICE_INLINE std::int32_t lane_index() {
    return 0;
}

// ---- N lanes

CREVICE_INLINE bool any(WideMask<8> m) {
    // Halves joined while still vectors, then two 64-bit words: the shortest that both compilers find.
    typedef std::int64_t Words __attribute__((vector_size(16)));
    const Words words = __builtin_bit_cast(Words, low_half(m.v) | high_half(m.v));
    return (words[0] | words[1]) != 0;
}
CREVICE_INLINE bool all(WideMask<8> m) { return !any(!m); }
template <int N>
CREVICE_INLINE std::int32_t largest_of(WideInt<N> a) {
    std::int32_t largest = a.v[0];
    for (int i = 1; i < N; ++i) largest = a.v[i] > largest ? a.v[i] : largest;
    return largest;
}
template <class Half>
CREVICE_INLINE WideDouble<8> joined(Half low, Half high) {
    return WideDouble<8>(__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7));
}
// The upper 32 bits of each: the sign comes first.
CREVICE_INLINE WideInt<8> upper_bits(WideDouble<8> a) {
    typedef std::int32_t Words __attribute__((vector_size(64)));
    const Words words = __builtin_bit_cast(Words, a.v);
    return WideInt<8>(__builtin_shufflevector(words, words, 1, 3, 5, 7, 9, 11, 13, 15));
}
template <class T, int N>
CREVICE_INLINE WideOf<T, N> select(WideMask<N> m, WideOf<T, N> a, WideOf<T, N> b) {
    if constexpr (sizeof(T) == sizeof(std::int32_t)) {
        return WideOf<T, N>(m.v ? a.v : b.v);
    } else {
        typedef std::int64_t Half __attribute__((vector_size(32)));
        const auto low = __builtin_convertvector(low_half(m.v), Half) ? low_half(a.v) : low_half(b.v);
        const auto high = __builtin_convertvector(high_half(m.v), Half) ? high_half(a.v) : high_half(b.v);
        return joined(low, high);
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
template <class T, int N>
CREVICE_INLINE WideOf<T, N> gather(const T* base, WideInt<N> index) {
    WideOf<T, N> r;
    for (int i = 0; i < N; ++i) r.v[i] = base[index.v[i]];
    return r;
}
template <class F, class T>
    requires(kLanes<F> > 1)
CREVICE_INLINE WideOf<T, kLanes<F>> load(const T* at) {
    WideOf<T, kLanes<F>> r;
    std::memcpy(&r.v, at, sizeof r.v);
    return r;
}
template <class T, int N>
CREVICE_INLINE void store(T* at, WideOf<T, N> a) {
    std::memcpy(at, &a.v, sizeof a.v);
}
template <class F>
    requires(kLanes<F> > 1)
CREVICE_INLINE Int<F> lane_index() {
    Int<F> r;
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
    return joined(larger(low_half(a.v), low_half(b.v)), larger(high_half(a.v), high_half(b.v)));
}
template <int N>
CREVICE_INLINE WideDouble<N> min_of(WideDouble<N> a, WideDouble<N> b) {
    const auto smaller = [](auto x, auto y) __attribute__((always_inline)) { return x < y ? x : y; };
    return joined(smaller(low_half(a.v), low_half(b.v)), smaller(high_half(a.v), high_half(b.v)));
}
// a clamped to [0,1]; NaN becomes 0.
template <class F>
CREVICE_INLINE F saturate(F a) {
    return min_of(max_of(a, F(0)), F(1));
}
template <class F>
CREVICE_INLINE F absolute(F a) {
    return select(a < F(0), F(0) - a, a);
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
// Largest whole number <= a, for |a| < 2^31.
template <class F>
CREVICE_INLINE Int<F> floor_to_int(F a) {
    const Int<F> whole = to_int(a);
    return select(from_int<F>(whole) > a, whole - Int<F>(1), whole);
}
// Nearest whole number, ties to even, for |a| < 2^31.
template <class F>
CREVICE_INLINE Int<F> round_half_even(F a) {
    const Int<F> below = floor_to_int(a);
    const F fraction = a - from_int<F>(below);
    const auto odd = (below & Int<F>(1)) == Int<F>(1);
    const auto up = (fraction > F(0.5f)) | ((fraction == F(0.5f)) & odd);
    return select(up, below + Int<F>(1), below);
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
