// A texture with its mip chain: colours in linear light, or the values of a normal map; alpha where there is
// any.
#pragma once

#include <filesystem>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/image.h"

namespace crevice {

struct Texture {
    // [0] is the full size; each next is max(1, half), down to 1x1. RGB in [0,1], linear light.
    std::vector<Image3> mips;
    // One plane for each of the above, in [0,1], linear: 0 is not there, 1 is. Empty: 1 everywhere.
    std::vector<Image<float>> alpha_mips;
};

// The mip chain of a linear-light image: each level is the box-filtered mean of the one above (odd sizes
// weigh by area). Alpha likewise, if given; colours are not weighted by it, since it may mean anything (in a
// normal map it is the shininess), so a cut-out's colours must go on beyond its outline. Under an alpha test
// the mean of alpha keeps its sum, not its coverage: see keep_coverage. Throws UsageError when `alpha` is
// neither empty nor of the size of `base`.
Texture build_texture(Image3 base, Image<float> alpha = {});

// What the codes of a file mean. Alpha is linear in both.
enum class TextureEncoding {
    srgb,    // colours
    linear,  // data, such as normals: code / 255
};

// Reads PNG, JPEG or TGA (8-bit). Alpha is kept where a file has it (of a TGA: where its header counts alpha
// bits) and where it is not 1 everywhere. Throws InputError when the file is missing, not a regular file,
// damaged, or larger than kMaxTextureSide on a side.
inline constexpr int kMaxTextureSide = 16384;
Texture load_texture(const std::filesystem::path& path, TextureEncoding encoding = TextureEncoding::srgb);

}  // namespace crevice
