// Several pixels as one value: the types, with arithmetic and comparison, over the compiler's vector extensions.
// What kernels call on them is in wide.h.
//
// Everything that takes a Wide by value is CREVICE_INLINE: passed to a function that is not inlined, a Wide
// would change its calling convention with the instruction set. In gdb: `skip -gfi *wide*.h`.
#pragma once

#include <cstdint>
#include <type_traits>

namespace crevice {

#define CREVICE_INLINE [[gnu::always_inline]] inline

// Before a loop over the elements of a vector: each pass of it becomes straight code, for else the vector would go
// through memory.
#ifdef __clang__
#define CREVICE_UNROLLED _Pragma("clang loop unroll(full)")
#else
#define CREVICE_UNROLLED _Pragma("GCC unroll 8")
#endif

// The native vector of N elements. A trait, because GCC 12 drops vector_size written inside a class template.
template <class T, int N>
struct VectorOf;
#define CREVICE_VECTOR(T, N)                                        \
    template <>                                                     \
    struct VectorOf<T, N> {                                         \
        typedef T type __attribute__((vector_size(sizeof(T) * N))); \
    };
CREVICE_VECTOR(float, 4)
CREVICE_VECTOR(float, 8)
CREVICE_VECTOR(double, 2)
CREVICE_VECTOR(double, 4)
CREVICE_VECTOR(double, 8)
CREVICE_VECTOR(std::int32_t, 4)
CREVICE_VECTOR(std::int32_t, 8)
CREVICE_VECTOR(std::uint32_t, 4)
CREVICE_VECTOR(std::uint32_t, 8)
CREVICE_VECTOR(std::int64_t, 2)
CREVICE_VECTOR(std::int64_t, 4)
CREVICE_VECTOR(std::int64_t, 8)
#undef CREVICE_VECTOR

// As many doubles as there are floats in a register fill two registers. They are compared, selected and shuffled
// half by half: GCC 12 does that to vectors wider than the register one element at a time. Eight are two vectors
// from the start (wide_halves.h).
template <class V>
inline constexpr int kElements = static_cast<int>(sizeof(V) / sizeof(V{}[0]));

template <class V>
CREVICE_INLINE auto low_half(V v) {
    if constexpr (kElements<V> == 8) {
        return __builtin_shufflevector(v, v, 0, 1, 2, 3);
    } else {
        return __builtin_shufflevector(v, v, 0, 1);
    }
}
template <class V>
CREVICE_INLINE auto high_half(V v) {
    if constexpr (kElements<V> == 8) {
        return __builtin_shufflevector(v, v, 4, 5, 6, 7);
    } else {
        return __builtin_shufflevector(v, v, 2, 3);
    }
}
template <class Half>
CREVICE_INLINE auto joined(Half low, Half high) {
    if constexpr (kElements<Half> == 4) {
        return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    } else {
        return __builtin_shufflevector(low, high, 0, 1, 2, 3);
    }
}

// Eight words whose middle pairs change places: shuffles inside each half of a 256-bit register are cheap, and so is
// this way back.
CREVICE_INLINE auto in_lane_order(VectorOf<std::int32_t, 8>::type words) {
    const auto pairs = __builtin_bit_cast(VectorOf<std::int64_t, 4>::type, words);
    return __builtin_bit_cast(VectorOf<std::int32_t, 8>::type,
                              __builtin_shufflevector(pairs, pairs, 0, 2, 1, 3));
}

// The 32-bit words of two vectors that stand at even places, or those at odd places. Of eight 64-bit elements the
// lower words are the even ones.
template <class Half>
CREVICE_INLINE auto even_words(Half low, Half high) {
    using Words = typename VectorOf<std::int32_t, sizeof(Half) / sizeof(std::int32_t)>::type;
    const auto a = __builtin_bit_cast(Words, low), b = __builtin_bit_cast(Words, high);
    if constexpr (kElements<Words> == 8) {
        return in_lane_order(__builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14));
    } else {
        return __builtin_shufflevector(a, b, 0, 2, 4, 6);
    }
}
template <class Half>
CREVICE_INLINE auto odd_words(Half low, Half high) {
    using Words = typename VectorOf<std::int32_t, sizeof(Half) / sizeof(std::int32_t)>::type;
    const auto a = __builtin_bit_cast(Words, low), b = __builtin_bit_cast(Words, high);
    if constexpr (kElements<Words> == 8) {
        return in_lane_order(__builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15));
    } else {
        return __builtin_shufflevector(a, b, 1, 3, 5, 7);
    }
}

// The scalar in every element: the form of which each compiler makes one broadcast. Of four elements that is a shuffle
// (GCC 12 inserts those of a loop one by one, Clang keeps the loop in WebAssembly), of eight a loop (GCC 12 inserts
// those of a shuffle).
template <class V, class T>
CREVICE_INLINE V spread_vector(T scalar) {
    if constexpr (kElements<V> == 8) {
        V v = {};  // else GCC 12 for aarch64 takes it for uninitialized
        for (int i = 0; i < 8; ++i) v[i] = scalar;
        return v;
    } else {
        const V first = {scalar};
        return __builtin_shufflevector(first, first, 0, 0, 0, 0);
    }
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
    CREVICE_INLINE WideOf(T scalar) : v(spread_vector<V>(scalar)) {}
    CREVICE_INLINE explicit WideOf(V vector) : v(vector) {}
    // Written out, because GCC 12 takes a copy that it writes itself apart into words, on the way through memory.
    CREVICE_INLINE WideOf(const WideOf& o) : v(o.v) {}
    CREVICE_INLINE WideOf& operator=(const WideOf& o) {
        v = o.v;
        return *this;
    }

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
        return compare(
            a, b, [](auto x, auto y) __attribute__((always_inline)) { return x < y; });
    }
    CREVICE_INLINE friend WideMask<N> operator<=(WideOf a, WideOf b) {
        return compare(
            a, b, [](auto x, auto y) __attribute__((always_inline)) { return x <= y; });
    }
    CREVICE_INLINE friend WideMask<N> operator>(WideOf a, WideOf b) {
        return compare(
            a, b, [](auto x, auto y) __attribute__((always_inline)) { return x > y; });
    }
    CREVICE_INLINE friend WideMask<N> operator>=(WideOf a, WideOf b) {
        return compare(
            a, b, [](auto x, auto y) __attribute__((always_inline)) { return x >= y; });
    }
    CREVICE_INLINE friend WideMask<N> operator==(WideOf a, WideOf b) {
        return compare(
            a, b, [](auto x, auto y) __attribute__((always_inline)) { return x == y; });
    }
    CREVICE_INLINE friend WideMask<N> operator!=(WideOf a, WideOf b) {
        return compare(
            a, b, [](auto x, auto y) __attribute__((always_inline)) { return x != y; });
    }

 private:
    template <class Comparison>
    CREVICE_INLINE static WideMask<N> compare(WideOf a, WideOf b, Comparison holds) {
        if constexpr (sizeof(T) == sizeof(std::int32_t)) {
            return {holds(a.v, b.v)};
        } else {
            return {even_words(holds(low_half(a.v), low_half(b.v)), holds(high_half(a.v), high_half(b.v)))};
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

}  // namespace crevice
