// A colour texture with its mip chain, in linear light.
#pragma once

#include <filesystem>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/image.h"

namespace crevice {

struct Texture {
    std::vector<Image3>
        mips;  // [0] is the full size; each next is max(1, half), down to 1x1. RGB in [0,1], linear light
};

// The mip chain of a linear-light image: each level is the box-filtered mean of the one above (odd sizes
// weigh by area).
Texture build_texture(Image3 base);

// Reads PNG, JPEG or TGA (8-bit, sRGB-encoded; alpha is dropped). Throws InputError when the file is missing,
// not a regular file, damaged, or larger than kMaxTextureSide on a side.
inline constexpr int kMaxTextureSide = 16384;
Texture load_texture(const std::filesystem::path& path);

}  // namespace crevice
