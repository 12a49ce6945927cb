// The last pass of both tutorials: the scene drawn again with its lights, depth test EQUAL and no depth
// write, the ambient terms multiplied by accessibility, and the sky behind.
// Source: seed 000 (Phong, Lighting.hlsl of its series), seed 002 (Default.hlsl: Blinn-Phong with the Schlick
//         approximation)
// In:     a scene, its camera; the depth buffer of the first pass; an AO map of any size (empty: all open)
// Out:    RGB in linear light, >= 0, may exceed 1; sky colour where no fragment passed
// Reads:  the AO map linear, clamped, at the pixel's centre
// Differs from the tutorials: accessibility multiplies every ambient term (seed 000's text: the directional
//         lights' only); no shadow map yet.
#pragma once

#include "rasterizer/depth_buffer.h"
#include "rasterizer/raster_tile.h"
#include "rasterizer/screen_geometry.h"

namespace crevice {

struct ShadeSettings {
    DepthFunction depth_function = DepthFunction::equal;
    PositionOrder position_order = PositionOrder::relative;
    DepthBias depth_bias;
};

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const Run& run = {});
Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const ShadeSettings& settings, const Run& run = {});

// The same from geometry that another pass of this view shares.
Image3 shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
             const DepthBuffer& depth, const Image<float>& ao, const ShadeSettings& settings = {},
             const Run& run = {});

// An AO map brought to picture size, filtered linearly. 1 everywhere when the map is empty.
Image<float> ao_at_picture_size(const Image<float>& ao, Size picture, const Run& run = {});

}  // namespace crevice
