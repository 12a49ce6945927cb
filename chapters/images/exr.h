// OpenEXR files of many layers: one file a frame for viewers and compositors. Built with OpenEXR where the build finds it;
// without it everything here throws UsageError that says so.
// Source: https://openexr.com, "Technical Introduction"; names of layers: NAME.X, with everything before the last point
//         the layer
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rasterizer/base/npy.h"

namespace crevice {

// Throws UsageError where the program was built without OpenEXR.
void require_openexr();

// One plane on its way into a file.
struct ExrChannel {
    std::string name;  // "normal.X"
    const Image<float>* plane = nullptr;
};

// A file of float32, ZIP. Channels of one size share a part of the file; one part makes a plain file, which every reader
// takes, several a multi-part one, named "part_WIDTHxHEIGHT" in the order in which the sizes first come. The bits of NaN,
// infinities and -0 survive.
std::string exr_bytes(std::span<const ExrChannel> channels);

// One buffer of a file.
struct ExrLayer {
    // "normal"; "" of bare R, G, B; "ao_raw" of ao.raw, whose last part is no single letter.
    std::string name;
    Planes planes;        // R, G, B or X, Y, Z or U, V, those that there are, or one of another name
    Image<float> alpha;   // of A; empty: it has none
    bool colour = false;  // R, G and B: light, by the format's rule linear
};

// The layers in the order of the file, of float32 and float16, in lines or flat tiles. A layer that holds colour and depth
// (R, G, B, Z) makes two; the second is named after its letters. Throws InputError naming the file: damaged, cut short,
// deep, subsampled or whole-number channels, 2^30 values or more.
std::vector<ExrLayer> exr_layers(const std::string& bytes, const std::string& name);

}  // namespace crevice
