// Texture filtering: D3D11.3 functional spec 7.18, with weights of full float precision.
//
// Coordinates: u and v run over [0,1] from the left edge of the first texel to the right edge of the last;
// the centre of texel i of N is at (i + 1/2) / N. A coordinate that is not a number counts as 0, and so does
// an infinite one with wrap. Every filter gives a finite answer for any coordinates and steps, a constant
// texture as exactly that constant, and in general a value between the smallest and the largest texel (to a
// rounding).
//
// The kernel (texture_probes.h) is large, so it is compiled in sample_texture.cpp alone; pixels come and colours
// go through memory, as many at a time as there are lanes.
#pragma once

#include <span>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/base/run.h"
#include "rasterizer/textures/sampler.h"
#include "rasterizer/textures/texture.h"

namespace crevice {

// Where pixels lie in a texture, one a lane.
struct SampledPixels {
    alignas(64) float u[kMostLanes], v[kMostLanes];
    alignas(64) float du_dx[kMostLanes], dv_dx[kMostLanes];  // uv from the pixel to the next one in x
    alignas(64) float du_dy[kMostLanes], dv_dy[kMostLanes];  // in y
    alignas(64) std::int32_t wanted[kMostLanes];             // all bits set, or 0: nothing is sampled
};

// RGB in linear light and alpha, one pixel a lane; 0 where nothing was wanted. Alpha is 1 where the texture has
// none.
struct SampledColours {
    alignas(64) float r[kMostLanes], g[kMostLanes], b[kMostLanes], a[kMostLanes];
};

// The colours of one texture or two at lane_count(run) pixels. The mip level is that whose texels are as wide as
// the longer of the two steps; with the anisotropic filter, see footprint_of. Each texture has at least one
// level, the sampler is valid. Two of one size share the work of finding texels, which is half of all.
void sample_textures(std::span<const Texture* const> textures, const Sampler& sampler,
                     const SampledPixels& pixels, SampledColours* colours, const Run& run);

// One pixel.
glm::vec4 sample_texture(const Texture& texture, const Sampler& sampler, glm::vec2 uv, glm::vec2 duv_dx,
                         glm::vec2 duv_dy);

}  // namespace crevice
