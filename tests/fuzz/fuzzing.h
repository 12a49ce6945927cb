// What the fuzz targets share: every file NAME_fuzz.cpp is a program of libFuzzer that gives the bytes it
// makes up to one reader. A reader may refuse them with an Error; anything else that happens is a finding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "rasterizer/base/error.h"

namespace crevice {

inline std::string bytes_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

template <class Reader>
void refused_or_read(const Reader& reader) {
    try {
        reader();
    } catch (const Error&) {
    }
}

}  // namespace crevice
