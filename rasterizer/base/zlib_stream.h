// Bytes as a zlib stream (RFC 1950), compressed on all threads.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "rasterizer/base/run.h"

namespace crevice {

// `bytes` in strips that are compressed apart, each without looking back at the one before; the same stream for any number of
// threads. Throws OutputError where there is too little memory.
std::string zlib_stream(std::span<const std::uint8_t> bytes, const Run& run);

}  // namespace crevice
