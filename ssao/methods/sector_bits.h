// The sectors of a slice as the bits of a whole number, in every lane: runs of bits, and how many there are.
#pragma once

#include <array>
#include <cstdint>

#include "rasterizer/lanes/wide.h"

namespace crevice {

inline constexpr int kSectors = 32;

// Entry k has its k lowest bits set, for 0 <= k <= 32. Lanes cannot shift by different counts, but they can read.
inline constexpr std::array<std::int32_t, kSectors + 1> kLowestBits = [] {
    std::array<std::int32_t, kSectors + 1> table{};
    for (std::size_t k = 0; k < table.size(); ++k)
        table[k] = static_cast<std::int32_t>(static_cast<std::uint32_t>((std::uint64_t{1} << k) - 1));
    return table;
}();

// Bits first ... end - 1, for 0 <= first <= end <= 32.
template <class I>
CREVICE_INLINE I bits_between(I first, I end) {
    return gather(kLowestBits.data(), end) - gather(kLowestBits.data(), first);
}

// Those of `bits` that are not in `mask`. The subtraction neither borrows nor overflows: one number holds the other.
template <class I>
CREVICE_INLINE I bits_outside(I bits, I mask) {
    return (mask | bits) - mask;
}

// How many bits are set. In two halves, so that no number is negative, and no sum overflows.
template <class I>
CREVICE_INLINE I bit_count(I bits) {
    const I twos(0x5555), fours(0x3333), bytes(0x0f0f);
    const auto of_half = [&](I half) __attribute__((always_inline)) {
        const I pairs = half - ((half >> 1) & twos);
        return (pairs & fours) + ((pairs >> 2) & fours);
    };
    const I nibbles = of_half(bits & I(0xffff)) + of_half((bits >> 16) & I(0xffff));
    const I sums = (nibbles & bytes) + ((nibbles >> 4) & bytes);
    return (sums + (sums >> 8)) & I(0x3f);
}

}  // namespace crevice
