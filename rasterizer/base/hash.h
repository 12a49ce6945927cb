// The one source of random numbers: an integer hash, the same on every machine.
#pragma once

#include <cstdint>

namespace crevice {

// A well-mixed 32-bit hash of a seed and two coordinates (Jarzynski & Olano 2020, pcg3d, first component).
inline std::uint32_t hash_of(std::uint32_t seed, std::uint32_t a, std::uint32_t b) {
    constexpr std::uint32_t kMultiplier = 1664525u, kIncrement = 1013904223u;
    std::uint32_t x = seed * kMultiplier + kIncrement, y = a * kMultiplier + kIncrement,
                  z = b * kMultiplier + kIncrement;
    for (int round = 0; round < 2; ++round) {
        x += y * z;
        y += z * x;
        z += x * y;
        if (round == 0) {
            x ^= x >> 16;
            y ^= y >> 16;
            z ^= z >> 16;
        }
    }
    return x;
}

// The upper 24 bits of a hash as a number in [0, 1).
inline float unit_number(std::uint32_t hash) {
    return static_cast<float>(static_cast<std::int32_t>(hash >> 8)) * 0x1p-24f;
}

}  // namespace crevice
