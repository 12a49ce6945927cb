// Texture filtering: D3D11.3 functional spec 7.18, with weights of full float precision.
//
// Coordinates: u and v run over [0,1] from the left edge of the first texel to the right edge of the last;
// the centre of texel i of N is at (i + 1/2) / N. A coordinate that is not a number counts as 0, and so does
// an infinite one with wrap. Every filter gives a finite answer for any coordinates and steps, a constant
// texture as exactly that constant, and in general a value between the smallest and the largest texel (to a
// rounding).
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/sampler.h"
#include "rasterizer/texture.h"

namespace crevice {

// RGB and alpha at uv. `duv_dx` and `duv_dy` say how far uv moves from this pixel to the next in x and in y.
// The mip level is that whose texels are as wide as the longer of the two; with the anisotropic filter, see
// footprint_of. The texture has at least one mip, the sampler is valid. Alpha is 1 where the texture has
// none.
glm::vec4 sample_texture(const Texture& texture, const Sampler& sampler, glm::vec2 uv, glm::vec2 duv_dx,
                         glm::vec2 duv_dy);

// The colour that a Sampler without further wishes gives: trilinear, wrap.
glm::vec3 sample_trilinear(const Texture& texture, glm::vec2 uv, glm::vec2 duv_dx, glm::vec2 duv_dy);

// Bilinear colour of one mip level, wrap.
glm::vec3 sample_bilinear(const Image3& level, glm::vec2 uv);

// How an anisotropic filter covers a pixel.
struct Footprint {
    int probes = 1;                 // trilinear ones, of equal weight
    glm::vec2 axis = glm::vec2(0);  // texels of the full size, from end to end of the row of probes
    float squared_width = 0;  // texels^2 of the full size: a probe's own footprint, which gives its level
};

// A pixel whose neighbours lie `dx` and `dy` texels away is taken for the ellipse that the unit circle
// becomes. Its longer axis is covered by up to `max_probes` probes, each as wide as the shorter axis, but at
// least a texel (nothing finer is there to be seen); where the probes do not suffice they widen. A circle
// needs one.
Footprint footprint_of(glm::vec2 dx, glm::vec2 dy, int max_probes);

}  // namespace crevice
