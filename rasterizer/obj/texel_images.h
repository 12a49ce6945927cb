// What the pictures of materials are turned into before they become textures.
#pragma once

#include "rasterizer/obj/mtl_texture.h"
#include "rasterizer/textures/image_file.h"

namespace crevice {

// One channel of a picture; `unsaid`: alpha where it has some, else luminance (Rec. 709).
Image<float> channel_of(const DecodedImage& image, TexelChannel channel);

// The picture larger or smaller, bilinear between texel centres.
Image<float> resized(const Image<float>& image, Size size);

// Whether data / 255 are normals: not grey, and on the mean of about unit length and pointing outward.
bool holds_normals(const Image3& data);

// A normal map of the lab (mapped_normal, green down the picture) from one whose green points up, `steepness`
// times as steep.
Image3 normals_with_green_down(Image3 data, float steepness);

// The normals of a height map that repeats itself and rises by `rise` widths of the picture from black to
// white.
Image3 normals_of_heights(const Image<float>& heights, float rise);

}  // namespace crevice
