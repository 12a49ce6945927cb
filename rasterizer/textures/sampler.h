// How a texture is read: what Direct3D calls a sampler state.
#pragma once

#include <glm/vec4.hpp>

namespace crevice {

enum class TextureFilter {
    point,        // the nearest texel of the nearest mip level
    bilinear,     // four texels of the nearest mip level
    trilinear,    // four texels of each of the two nearest levels
    anisotropic,  // trilinear probes along the longer axis of the pixel's footprint
};

// What lies outside [0,1]: the texture again, its nearest edge texel, or the border colour.
enum class AddressMode { wrap, clamp, border };

struct Sampler {
    TextureFilter filter = TextureFilter::trilinear;
    int max_anisotropy = 8;  // probes, 1 to 16; anisotropic only; 1 is trilinear
    AddressMode address_u = AddressMode::wrap, address_v = AddressMode::wrap;
    glm::vec4 border = {0, 0, 0, 1};  // RGB linear light, alpha; each in [0,1]

    friend bool operator==(const Sampler&, const Sampler&) = default;
};

// Throws UsageError when a member is out of its range.
void validate(const Sampler& sampler);

}  // namespace crevice
