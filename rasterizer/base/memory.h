// How much memory there is.
#pragma once

#include <cstdint>

namespace crevice {

// Bytes of physical memory; the largest number where the system does not tell.
std::uintmax_t memory_bytes();

}  // namespace crevice
