// Random numbers that are the same in every run.
#pragma once

#include <cstdint>

namespace crevice {

// Reproducible numbers in tests: a 64-bit linear congruential sequence, its high bits. Two of them in one
// expression need braces: the order in which arguments in parentheses are evaluated is the compiler's own.
class RandomSequence {
 public:
    explicit RandomSequence(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}

    std::uint32_t bits() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::uint32_t>(state_ >> 32);
    }
    double between(double low, double high) { return low + (high - low) * (bits() / 4294967296.0); }
    int whole(int low, int high) {  // inclusive
        return low + static_cast<int>(bits() % static_cast<std::uint32_t>(high - low + 1));
    }

 private:
    std::uint64_t state_;
};

}  // namespace crevice
