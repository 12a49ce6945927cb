// The 64-bit FNV-1a hash of bytes: tells contents apart, and is no protection against forgery.
#pragma once

#include <cstdint>
#include <string>

namespace crevice {

class Fnv1a {
 public:
    void add(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3u; }
    // Byte by byte, the lowest first.
    void add(std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) add(static_cast<std::uint8_t>(word >> shift));
    }
    // 16 digits.
    std::string hex() const {
        std::string digits;
        for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[hash_ >> shift & 15];
        return digits;
    }

 private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace crevice
