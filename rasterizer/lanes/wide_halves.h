// Doubles by halves. Eight are two vectors of four, AVX2's register, and sixteen two of eight: GCC 12 keeps a vector that is
// wider than the register in memory, and every step of a loop over it goes there and back.
#pragma once

#include <cstring>

#include "rasterizer/lanes/wide_types.h"

namespace crevice {

template <int N>
requires(N >= 8) struct WideOf<double, N> {
    using Half = typename VectorOf<double, N / 2>::type;
    Half low, high;

    CREVICE_INLINE WideOf() = default;
    CREVICE_INLINE WideOf(double scalar) : low(spread_half(scalar)), high(low) {}
    CREVICE_INLINE WideOf(Half lower, Half upper) : low(lower), high(upper) {}
    CREVICE_INLINE WideOf(const WideOf& o) : low(o.low), high(o.high) {}
    CREVICE_INLINE WideOf& operator=(const WideOf& o) {
        low = o.low;
        high = o.high;
        return *this;
    }

    CREVICE_INLINE double operator[](int lane) const { return lane < N / 2 ? low[lane] : high[lane - N / 2]; }
    CREVICE_INLINE friend WideOf operator+(WideOf a, WideOf b) { return {a.low + b.low, a.high + b.high}; }
    CREVICE_INLINE friend WideOf operator-(WideOf a, WideOf b) { return {a.low - b.low, a.high - b.high}; }
    CREVICE_INLINE friend WideOf operator*(WideOf a, WideOf b) { return {a.low * b.low, a.high * b.high}; }
    CREVICE_INLINE friend WideOf operator/(WideOf a, WideOf b) { return {a.low / b.low, a.high / b.high}; }
    CREVICE_INLINE friend WideOf operator-(WideOf a) { return {-a.low, -a.high}; }
    CREVICE_INLINE friend WideMask<N> operator<(WideOf a, WideOf b) { return compare<Comparison::less>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator<=(WideOf a, WideOf b) { return compare<Comparison::less_equal>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator>(WideOf a, WideOf b) { return compare<Comparison::greater>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator>=(WideOf a, WideOf b) { return compare<Comparison::greater_equal>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator==(WideOf a, WideOf b) { return compare<Comparison::equal>(a, b); }
    CREVICE_INLINE friend WideMask<N> operator!=(WideOf a, WideOf b) { return compare<Comparison::unequal>(a, b); }

 private:
    template <Comparison kHow>
    CREVICE_INLINE static WideMask<N> compare(WideOf a, WideOf b) {
        return WideMask<N>::template where<kHow>(a.low, a.high, b.low, b.high);
    }
    // By way of eight, here and where numbers are converted: GCC 12 spreads and converts to eight doubles in one
    // instruction a register, but to four in two and more.
    CREVICE_INLINE static Half spread_half(double scalar) {
        const auto eight = spread_vector<VectorOf<double, 8>::type>(scalar);
        if constexpr (N == 8) {
            return low_half(eight);
        } else {
            return eight;
        }
    }
};

// The same names for four doubles, which are one vector: that is a register of AVX2, two of the baseline form.
CREVICE_INLINE auto low_half(WideDouble<4> a) { return low_half(a.v); }
template <int N>
requires(N >= 8) CREVICE_INLINE auto low_half(WideDouble<N> a) { return a.low; }
CREVICE_INLINE auto high_half(WideDouble<4> a) { return high_half(a.v); }
template <int N>
requires(N >= 8) CREVICE_INLINE auto high_half(WideDouble<N> a) { return a.high; }
CREVICE_INLINE WideDouble<4> of_halves(VectorOf<double, 2>::type low, VectorOf<double, 2>::type high) {
    return WideDouble<4>(joined(low, high));
}
CREVICE_INLINE WideDouble<8> of_halves(VectorOf<double, 4>::type low, VectorOf<double, 4>::type high) {
    return {low, high};
}
CREVICE_INLINE WideDouble<16> of_halves(VectorOf<double, 8>::type low, VectorOf<double, 8>::type high) {
    return {low, high};
}

// What wide.h has for other vectors, of eight doubles and of sixteen.
CREVICE_INLINE WideInt<8> to_int(WideDouble<8> a) {
    return WideInt<8>(__builtin_convertvector(joined(a.low, a.high), WideInt<8>::V));
}
CREVICE_INLINE Wide<8> to_float(WideDouble<8> a) {
    return Wide<8>(__builtin_convertvector(joined(a.low, a.high), Wide<8>::V));
}
template <class T>
CREVICE_INLINE WideDouble<8> to_double(WideOf<T, 8> a) {
    const auto whole = __builtin_convertvector(a.v, VectorOf<double, 8>::type);
    return {low_half(whole), high_half(whole)};
}
CREVICE_INLINE WideInt<16> to_int(WideDouble<16> a) {
    return WideInt<16>(joined(__builtin_convertvector(a.low, WideInt<8>::V),
                              __builtin_convertvector(a.high, WideInt<8>::V)));
}
CREVICE_INLINE Wide<16> to_float(WideDouble<16> a) {
    return Wide<16>(
        joined(__builtin_convertvector(a.low, Wide<8>::V), __builtin_convertvector(a.high, Wide<8>::V)));
}
template <class T>
CREVICE_INLINE WideDouble<16> to_double(WideOf<T, 16> a) {
    using Half = WideDouble<16>::Half;
    return {__builtin_convertvector(low_half(a.v), Half), __builtin_convertvector(high_half(a.v), Half)};
}
template <int N>
requires(N >= 8) CREVICE_INLINE void store(double* at, WideDouble<N> a) {
    std::memcpy(at, &a.low, sizeof a.low);
    std::memcpy(at + N / 2, &a.high, sizeof a.high);
}

}  // namespace crevice
