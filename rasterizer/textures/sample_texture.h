// Texture filtering: D3D11.3 functional spec 7.18, with weights of full float precision.
//
// Coordinates: u and v run over [0,1] from the left edge of the first texel to the right edge of the last;
// the centre of texel i of N is at (i + 1/2) / N. A coordinate that is not a number counts as 0, and so does
// an infinite one with wrap. Every filter gives a finite answer for any coordinates and steps, a constant
// texture as exactly that constant, and in general a value between the smallest and the largest texel (to a
// rounding).
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/textures/texture_probes.h"

namespace crevice {

// RGB and alpha at the pixels that are wanted, 0 elsewhere. The mip level is that whose texels are as wide as
// the longer of the two steps; with the anisotropic filter, see footprint_of. The texture has at least one
// level, the sampler is valid. Alpha is 1 where the texture has none.
template <class F>
CREVICE_INLINE TextureColour<F> sample_texture(const Texture& texture, const Sampler& sampler,
                                               const TextureCoordinates<F>& at) {
    SeenTexture<F> seen(texture);
    look_at(&seen, 1, sampler, at);
    return channels_of(seen.mean);
}

// The same of two textures. Of one size they share the work of finding texels, which is half of all.
template <class F>
struct TextureColours {
    TextureColour<F> first, second;
};
template <class F>
CREVICE_INLINE TextureColours<F> sample_textures(const Texture& first, const Texture& second,
                                                 const Sampler& sampler, const TextureCoordinates<F>& at) {
    SeenTexture<F> seen[2] = {SeenTexture<F>(first), SeenTexture<F>(second)};
    const bool alike = first.size() == second.size() && first.levels().size() == second.levels().size();
    const int together = alike ? 2 : 1;
    for (int i = 0; i < 2; i += together) look_at(seen + i, together, sampler, at);
    return {channels_of(seen[0].mean), channels_of(seen[1].mean)};
}

// One pixel.
glm::vec4 sample_texture(const Texture& texture, const Sampler& sampler, glm::vec2 uv, glm::vec2 duv_dx,
                         glm::vec2 duv_dy);

}  // namespace crevice
