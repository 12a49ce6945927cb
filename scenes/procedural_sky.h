// Skies made of arithmetic, for the tutorials' cube maps that may not be redistributed.
//
// From the zenith down: a gradient, haze that thickens to the horizon, clouds of value noise on a flat layer,
// the sun with its glow, and the ground below. Polynomials, square roots and an integer hash only: the same
// bits everywhere.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "rasterizer/textures/cube_map.h"

namespace crevice {

// Colours in linear light, >= 0; they may exceed 1 (the sun).
struct SkyLook {
    glm::vec3 zenith, middle, horizon;  // of the clear sky: straight up, at 30 degrees or so, at eye level
    glm::vec3 ground, ground_far;       // straight down, and at eye level
    glm::vec3 to_sun;                   // unit, world space
    glm::vec3 sun, glow;                // of the disc; added around it
    float sun_cosine;                   // of the disc's angular radius, in (0,1)
    glm::vec3 cloud_bright, cloud_dark;
    float cloud_cover;  // [0,1]: 0 a clear sky, 1 overcast
    float cloud_scale;  // > 0, cells of the coarsest noise for each height of the layer; more: smaller clouds
    std::uint32_t seed;
};

// In the mood of X_Jun's desertcube1024 and Luna's sunsetcube1024: pale blue over sand, and a low orange sun
// under purple. The suns stand where the scenes' first lights come from, the sunset's lower.
SkyLook desert_look();
SkyLook sunset_look();

// The colour in a unit direction.
glm::vec3 sky_colour(const SkyLook& look, glm::vec3 direction);

// `side` texels a face, a power of two up to kLargestCubeSide.
CubeMap procedural_sky(const SkyLook& look, int side = 512, const Run& run = {});

}  // namespace crevice
