// One truth value a lane, and the comparisons that give them.
//
// A vector of eight or fewer is compared to a vector of the same width: all bits of an element set, or none. AVX-512 has
// registers of a bit a lane for it. GCC 12 never uses them for what becomes of vector extensions, but takes comparisons of
// sixteen apart lane by lane, and broadcasts as well; so there its own builtins do both. Without optimization the
// extensions do: a kernel is then not inlined where its builtins are allowed.
#pragma once

#include <type_traits>

#include "rasterizer/lanes/wide_vectors.h"

#if defined(__x86_64__) && defined(__OPTIMIZE__) && !defined(__clang__)
#define CREVICE_MASK_REGISTERS
// Makes the builtins known. Those who call them are compiled for AVX-512 where they are inlined.
#pragma GCC push_options
#pragma GCC target("avx512f,avx512bw,avx512dq,avx512vl")
#pragma GCC pop_options
#endif

namespace crevice {

enum class Comparison { less, less_equal, greater, greater_equal, equal, unequal };

template <Comparison kHow, class V>
CREVICE_INLINE auto compared(V a, V b) {
    if constexpr (kHow == Comparison::less) return a < b;
    if constexpr (kHow == Comparison::less_equal) return a <= b;
    if constexpr (kHow == Comparison::greater) return a > b;
    if constexpr (kHow == Comparison::greater_equal) return a >= b;
    if constexpr (kHow == Comparison::equal) return a == b;
    if constexpr (kHow == Comparison::unequal) return a != b;
}

template <int N>
struct WideMask {
    using V = typename VectorOf<std::int32_t, N>::type;
    V v;

    // Of two vectors of 32-bit elements; of two of 64-bit ones, given by halves.
    template <Comparison kHow, class T>
    CREVICE_INLINE static WideMask where(T a, T b) {
        return {compared<kHow>(a, b)};
    }
    template <Comparison kHow, class Half>
    CREVICE_INLINE static WideMask where(Half low_a, Half high_a, Half low_b, Half high_b) {
        return {even_words(compared<kHow>(low_a, low_b), compared<kHow>(high_a, high_b))};
    }

    CREVICE_INLINE WideMask operator&(WideMask o) const { return {v & o.v}; }
    CREVICE_INLINE WideMask operator|(WideMask o) const { return {v | o.v}; }
    CREVICE_INLINE WideMask operator!() const { return {~v}; }
    CREVICE_INLINE bool operator[](int lane) const { return v[lane] != 0; }
};

#ifdef CREVICE_MASK_REGISTERS

// A bit a lane.
template <>
struct WideMask<16> {
    using Bits = std::uint16_t;
    Bits bits;

    template <Comparison kHow, class T>
    CREVICE_INLINE static WideMask where(T a, T b) {
        if constexpr (std::is_same_v<T, VectorOf<float, 16>::type>) {
            return {__builtin_ia32_cmpps512_mask(a, b, kOfFloats<kHow>, kAll, kRounding)};
        } else {
            return {__builtin_ia32_cmpd512_mask(a, b, kOfWords<kHow>, kAll)};
        }
    }
    template <Comparison kHow, class Half>
    CREVICE_INLINE static WideMask where(Half low_a, Half high_a, Half low_b, Half high_b) {
        const auto bits_of = [](Half a, Half b) __attribute__((always_inline)) {
            constexpr std::uint8_t all = 0xff;
            return unsigned{static_cast<std::uint8_t>(
                __builtin_ia32_cmppd512_mask(a, b, kOfFloats<kHow>, all, kRounding))};
        };
        return {static_cast<Bits>(bits_of(low_a, low_b) | bits_of(high_a, high_b) << 8)};
    }

    CREVICE_INLINE WideMask operator&(WideMask o) const { return {static_cast<Bits>(bits & o.bits)}; }
    CREVICE_INLINE WideMask operator|(WideMask o) const { return {static_cast<Bits>(bits | o.bits)}; }
    CREVICE_INLINE WideMask operator!() const { return {static_cast<Bits>(~bits)}; }
    CREVICE_INLINE bool operator[](int lane) const { return (bits >> lane & 1) != 0; }

    static constexpr Bits kAll = 0xffff;
    static constexpr int kRounding = 4;  // as it is

 private:
    // What the instructions call the comparisons, in the order of Comparison; NaN is only unequal.
    static constexpr int kFloats[] = {17, 18, 30, 29, 0, 4}, kWords[] = {1, 2, 6, 5, 0, 4};
    template <Comparison kHow>
    static constexpr int kOfFloats = kFloats[static_cast<int>(kHow)];
    template <Comparison kHow>
    static constexpr int kOfWords = kWords[static_cast<int>(kHow)];
};

CREVICE_INLINE auto spread_sixteen(float scalar) {
    using V = VectorOf<float, 16>::type;
    return __builtin_ia32_broadcastss512(VectorOf<float, 4>::type{scalar}, V{}, WideMask<16>::kAll);
}
CREVICE_INLINE auto spread_sixteen(std::int32_t scalar) {
    using V = VectorOf<std::int32_t, 16>::type;
    return __builtin_ia32_pbroadcastd512_gpr_mask(scalar, V{}, WideMask<16>::kAll);
}

#else

template <class T>
CREVICE_INLINE auto spread_sixteen(T scalar) {
    const typename VectorOf<T, 16>::type first = {scalar};
    return __builtin_shufflevector(first, first, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
}

#endif

}  // namespace crevice
