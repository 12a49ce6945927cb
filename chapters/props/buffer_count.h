// What the pass that writes normals and depths promises, counted over all pixels.
#pragma once

#include "rasterizer/draw/normal_depth.h"
#include "rasterizer/scene/camera.h"

namespace crevice {

struct BufferCount {
    int surface = 0;         // pixels that show one
    int facing = 0;          // those of them whose normal faces the eye
    int background = 0;      // pixels that show nothing
    int dirty = 0;           // those of them that hold anything but normal 0 and NDC depth 1
    float length_error = 0;  // the largest difference of a normal's length from 1
    float depth_error = 0;   // of the depth that A + B / z gives back from z itself, relative, the largest
};
// `ndc` holds the NDC depths of the same picture.
BufferCount count_pixels(const GBuffer& gbuffer, const Image<float>& ndc, const CameraMatrices& matrices);

}  // namespace crevice
