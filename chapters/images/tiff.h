// TIFF pictures, as renderers and ImageMagick write them. Built with libtiff (4.5 or newer) where the build finds it;
// without it everything here throws UsageError that says so.
#pragma once

#include <string>

#include "rasterizer/base/npy.h"

namespace crevice {

struct TiffImage {
    Planes planes;        // grey or RGB
    Image<float> alpha;   // of an extra sample; empty: it has none
    bool linear = false;  // float samples; else k / 255 or k / 65535
};

// The picture of a file, in strips or tiles: 8 or 16 bits or float16, float32 a sample, 1 to 4 samples. Throws InputError
// naming the file and what was found: another layout, a picture that is not upright, more than one.
TiffImage tiff_image(const std::string& bytes, const std::string& name);

}  // namespace crevice
