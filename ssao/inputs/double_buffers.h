// What a judge of rounding errors puts in the place of the float buffers: the same numbers in double. No frame has them.
#pragma once

#include <array>

#include "rasterizer/base/image.h"

namespace crevice {

inline Image<double> widened(const Image<float>& image) {
    Image<double> result(image.size);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) result.pixels[i] = image.pixels[i];
    return result;
}

// What the pixels of a picture show.
struct DoubleGBuffer {
    Image<double> view_depth;             // scene units; background +inf
    Image<double> ndc_depth;              // background that of the depth buffer
    std::array<Image<double>, 3> normal;  // x, y, z in view space, unit; background 0
    double depth_a = 0, depth_b = 0;      // CameraMatrices
};

// What the texels of an AO map show, and the depths that they are compared with: see AoInputs.
struct DoubleInputs {
    Image<double> view_depth;
    std::array<Image<double>, 3> normal;
    Image<double> depth_map;  // laid out as AoInputs::depth_map
    double depth_a = 0, depth_b = 0;
};

}  // namespace crevice
