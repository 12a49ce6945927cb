// A hash of lattice points, in lanes: what all noise here is made of. Whole numbers alone, so it has the same bits
// everywhere.
#pragma once

#include <cstdint>

#include "rasterizer/lanes/wide.h"

namespace crevice {

// 32 bits a lane, which wrap round.
template <class I>
struct HashBits;
template <>
struct HashBits<std::int32_t> {
    std::uint32_t v;
    CREVICE_INLINE HashBits(std::int32_t number) : v(static_cast<std::uint32_t>(number)) {}
    CREVICE_INLINE std::int32_t upper(int bits) const { return static_cast<std::int32_t>(v >> (32 - bits)); }
    CREVICE_INLINE std::int32_t lower_16() const { return static_cast<std::int32_t>(v & 0xffffu); }
};
template <int N>
struct HashBits<WideInt<N>> {
    typename VectorOf<std::uint32_t, N>::type v;
    CREVICE_INLINE HashBits(WideInt<N> number) : v(__builtin_bit_cast(decltype(v), number.v)) {}
    CREVICE_INLINE WideInt<N> upper(int bits) const { return numbers(v >> (32 - bits)); }
    CREVICE_INLINE WideInt<N> lower_16() const { return numbers(v & 0xffffu); }

 private:
    CREVICE_INLINE static WideInt<N> numbers(decltype(v) of) {
        return WideInt<N>(__builtin_bit_cast(typename WideInt<N>::V, of));
    }
};

// Mixes all 32 bits into all 32: the finaliser of MurmurHash3.
template <class I>
CREVICE_INLINE HashBits<I> mixed(HashBits<I> h) {
    h.v ^= h.v >> 16;
    h.v *= 0x85ebca6bu;
    h.v ^= h.v >> 13;
    h.v *= 0xc2b2ae35u;
    h.v ^= h.v >> 16;
    return h;
}

}  // namespace crevice
