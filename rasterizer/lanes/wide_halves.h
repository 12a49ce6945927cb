// Doubles by halves. Eight are two vectors of four, AVX2's register: GCC 12 keeps one vector of eight in memory, and
// every step of a loop over it goes there and back.
#pragma once

#include <cstring>

#include "rasterizer/lanes/wide_types.h"

namespace crevice {

template <>
struct WideOf<double, 8> {
    using Half = VectorOf<double, 4>::type;
    using Whole = VectorOf<double, 8>::type;
    Half low, high;

    CREVICE_INLINE WideOf() = default;
    // By way of eight, here and where numbers are converted: GCC 12 spreads and converts to eight doubles in one
    // instruction a register, but to four in two and more.
    CREVICE_INLINE WideOf(double scalar) : low(low_half(spread_vector<Whole>(scalar))), high(low) {}
    CREVICE_INLINE WideOf(Half lower, Half upper) : low(lower), high(upper) {}
    CREVICE_INLINE WideOf(const WideOf& o) : low(o.low), high(o.high) {}
    CREVICE_INLINE WideOf& operator=(const WideOf& o) {
        low = o.low;
        high = o.high;
        return *this;
    }

    CREVICE_INLINE double operator[](int lane) const { return lane < 4 ? low[lane] : high[lane - 4]; }
    CREVICE_INLINE friend WideOf operator+(WideOf a, WideOf b) { return {a.low + b.low, a.high + b.high}; }
    CREVICE_INLINE friend WideOf operator-(WideOf a, WideOf b) { return {a.low - b.low, a.high - b.high}; }
    CREVICE_INLINE friend WideOf operator*(WideOf a, WideOf b) { return {a.low * b.low, a.high * b.high}; }
    CREVICE_INLINE friend WideOf operator/(WideOf a, WideOf b) { return {a.low / b.low, a.high / b.high}; }
    CREVICE_INLINE friend WideOf operator-(WideOf a) { return {-a.low, -a.high}; }
    CREVICE_INLINE friend WideMask<8> operator<(WideOf a, WideOf b) {
        return {even_words(a.low < b.low, a.high < b.high)};
    }
    CREVICE_INLINE friend WideMask<8> operator<=(WideOf a, WideOf b) {
        return {even_words(a.low <= b.low, a.high <= b.high)};
    }
    CREVICE_INLINE friend WideMask<8> operator>(WideOf a, WideOf b) {
        return {even_words(a.low > b.low, a.high > b.high)};
    }
    CREVICE_INLINE friend WideMask<8> operator>=(WideOf a, WideOf b) {
        return {even_words(a.low >= b.low, a.high >= b.high)};
    }
    CREVICE_INLINE friend WideMask<8> operator==(WideOf a, WideOf b) {
        return {even_words(a.low == b.low, a.high == b.high)};
    }
    CREVICE_INLINE friend WideMask<8> operator!=(WideOf a, WideOf b) {
        return {even_words(a.low != b.low, a.high != b.high)};
    }
};

// The same names for four doubles, which are one vector: that is a register of AVX2, two of the baseline form.
CREVICE_INLINE auto low_half(WideDouble<4> a) { return low_half(a.v); }
CREVICE_INLINE auto low_half(WideDouble<8> a) { return a.low; }
CREVICE_INLINE auto high_half(WideDouble<4> a) { return high_half(a.v); }
CREVICE_INLINE auto high_half(WideDouble<8> a) { return a.high; }
CREVICE_INLINE WideDouble<4> of_halves(VectorOf<double, 2>::type low, VectorOf<double, 2>::type high) {
    return WideDouble<4>(joined(low, high));
}
CREVICE_INLINE WideDouble<8> of_halves(VectorOf<double, 4>::type low, VectorOf<double, 4>::type high) {
    return {low, high};
}

// What wide.h has for other vectors, of eight doubles.
CREVICE_INLINE WideInt<8> to_int(WideDouble<8> a) {
    return WideInt<8>(__builtin_convertvector(joined(a.low, a.high), WideInt<8>::V));
}
CREVICE_INLINE Wide<8> to_float(WideDouble<8> a) {
    return Wide<8>(__builtin_convertvector(joined(a.low, a.high), Wide<8>::V));
}
template <class T>
CREVICE_INLINE WideDouble<8> to_double(WideOf<T, 8> a) {
    const auto whole = __builtin_convertvector(a.v, WideDouble<8>::Whole);
    return {low_half(whole), high_half(whole)};
}
CREVICE_INLINE void store(double* at, WideDouble<8> a) {
    std::memcpy(at, &a.low, sizeof a.low);
    std::memcpy(at + 4, &a.high, sizeof a.high);
}

}  // namespace crevice
