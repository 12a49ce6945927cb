// The compiler's vectors, and how they are taken apart and joined: what the lane types of wide_types.h are made of.
#pragma once

#include <cstdint>

namespace crevice {

#define CREVICE_INLINE [[gnu::always_inline]] inline

// Before a loop over the elements of a vector: each pass of it becomes straight code, for else the vector would go
// through memory.
#ifdef __clang__
#define CREVICE_UNROLLED _Pragma("clang loop unroll(full)")
#else
#define CREVICE_UNROLLED _Pragma("GCC unroll 16")
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
CREVICE_VECTOR(float, 16)
CREVICE_VECTOR(double, 2)
CREVICE_VECTOR(double, 4)
CREVICE_VECTOR(double, 8)
CREVICE_VECTOR(std::int32_t, 4)
CREVICE_VECTOR(std::int32_t, 8)
CREVICE_VECTOR(std::int32_t, 16)
CREVICE_VECTOR(std::uint32_t, 4)
CREVICE_VECTOR(std::uint32_t, 8)
CREVICE_VECTOR(std::uint32_t, 16)
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
    if constexpr (kElements<V> == 16) {
        return __builtin_shufflevector(v, v, 0, 1, 2, 3, 4, 5, 6, 7);
    } else if constexpr (kElements<V> == 8) {
        return __builtin_shufflevector(v, v, 0, 1, 2, 3);
    } else {
        return __builtin_shufflevector(v, v, 0, 1);
    }
}
template <class V>
CREVICE_INLINE auto high_half(V v) {
    if constexpr (kElements<V> == 16) {
        return __builtin_shufflevector(v, v, 8, 9, 10, 11, 12, 13, 14, 15);
    } else if constexpr (kElements<V> == 8) {
        return __builtin_shufflevector(v, v, 4, 5, 6, 7);
    } else {
        return __builtin_shufflevector(v, v, 2, 3);
    }
}
template <class Half>
CREVICE_INLINE auto joined(Half low, Half high) {
    if constexpr (kElements<Half> == 8) {
        return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    } else if constexpr (kElements<Half> == 4) {
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
    if constexpr (kElements<Words> == 16) {
        return __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    } else if constexpr (kElements<Words> == 8) {
        return in_lane_order(__builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14));
    } else {
        return __builtin_shufflevector(a, b, 0, 2, 4, 6);
    }
}
template <class Half>
CREVICE_INLINE auto odd_words(Half low, Half high) {
    using Words = typename VectorOf<std::int32_t, sizeof(Half) / sizeof(std::int32_t)>::type;
    const auto a = __builtin_bit_cast(Words, low), b = __builtin_bit_cast(Words, high);
    if constexpr (kElements<Words> == 16) {
        return __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
    } else if constexpr (kElements<Words> == 8) {
        return in_lane_order(__builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15));
    } else {
        return __builtin_shufflevector(a, b, 1, 3, 5, 7);
    }
}

}  // namespace crevice
