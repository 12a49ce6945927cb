// A plane as OpenEXR reads and writes it; for the files that are compiled with OpenEXR alone.
#pragma once

#include <cstdint>

#include <ImfFrameBuffer.h>

#include "rasterizer/base/image.h"

namespace crevice {

// Where OpenEXR finds the value of pixel (0, 0) of a window that begins at `first`.
inline Imf::Slice exr_slice(const Image<float>& plane, Imath::V2i first) {
    const auto row = static_cast<std::ptrdiff_t>(sizeof(float)) * plane.stride;
    // It counts pixels from the origin of its window's coordinates.
    const std::uintptr_t base =
        reinterpret_cast<std::uintptr_t>(plane.pixels.data()) -
        static_cast<std::uintptr_t>(first.y * row + first.x * std::ptrdiff_t{sizeof(float)});
    return Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(base), sizeof(float),
                      static_cast<std::size_t>(row));
}

}  // namespace crevice
