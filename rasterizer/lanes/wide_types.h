// Several pixels as one value: the types, with arithmetic and comparison, over the compiler's vector extensions.
// What kernels call on them is in wide.h.
//
// Everything that takes a Wide by value is CREVICE_INLINE: passed to a function that is not inlined, a Wide
// would change its calling convention with the instruction set. In gdb: `skip -gfi *wide*.h`.
#pragma once

#include "rasterizer/lanes/wide_masks.h"

namespace crevice {

// The scalar in every element: the form of which each compiler makes one broadcast. Of four elements that is a shuffle
// (GCC 12 inserts those of a loop one by one, Clang keeps the loop in WebAssembly), of eight a loop (GCC 12 inserts
// those of a shuffle). For sixteen see wide_masks.h.
template <class V, class T>
CREVICE_INLINE V spread_vector(T scalar) {
    if constexpr (kElements<V> == 16) {
        return spread_sixteen(scalar);
    } else if constexpr (kElements<V> == 8) {
        V v = {};  // else GCC 12 for aarch64 takes it for uninitialized
        for (int i = 0; i < 8; ++i) v[i] = scalar;
        return v;
    } else {
        const V first = {scalar};
        return __builtin_shufflevector(first, first, 0, 0, 0, 0);
    }
}

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
    CREVICE_INLINE friend WideMask<N> operator<(WideOf a, WideOf b) { return compare<Comparison::less>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator<=(WideOf a, WideOf b) { return compare<Comparison::less_equal>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator>(WideOf a, WideOf b) { return compare<Comparison::greater>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator>=(WideOf a, WideOf b) { return compare<Comparison::greater_equal>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator==(WideOf a, WideOf b) { return compare<Comparison::equal>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator!=(WideOf a, WideOf b) { return compare<Comparison::unequal>(a, b); }

 private:
    template <Comparison kHow>
    CREVICE_INLINE static WideMask<N> compare(WideOf a, WideOf b) {
        if constexpr (sizeof(T) == sizeof(std::int32_t)) {
            return WideMask<N>::template where<kHow>(a.v, b.v);
        } else {
            return WideMask<N>::template where<kHow>(low_half(a.v), high_half(a.v), low_half(b.v), high_half(b.v));
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
