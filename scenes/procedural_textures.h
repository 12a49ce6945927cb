// The textures of the built-in scenes, made in code: no files, the same bits everywhere.
#pragma once

#include <glm/vec3.hpp>

#include "rasterizer/textures/texture.h"

namespace crevice {

inline constexpr int kTextureSide = 512;  // texels; what the scenes use
inline constexpr int kSmallestTextureSide = 8, kLargestTextureSide = 4096;

// A surface that repeats in both directions: its opposite edges continue each other.
struct SurfaceMaps {
    Texture colour;  // albedo, linear light
    // RGB = n / 2 + 1/2: red along u (right), green along v (down), blue out of the surface. Alpha: the
    // factor of the material's shininess, as in Luna.
    Texture normal;
    Image<float> height;  // what the normals are of, in widths of the texture; texel centres
};

// All are square, `side` texels, painted on all threads; a side out of [kSmallestTextureSide, kLargestTextureSide] is a
// UsageError. They are functions of the position alone, so another side gives the same surface sampled otherwise.

// Four by four glazed clay tiles with rounded rims, each of its own shade, and rough grout between them.
SurfaceMaps floor_tile_textures(int side = kTextureSide, const Run& run = {});

// Running bond, four bricks across and ten courses, with chipped rims and sunken mortar.
SurfaceMaps brick_textures(int side = kTextureSide, const Run& run = {});

// Weathered grey stone: grain, pits and a few cracks.
SurfaceMaps rough_stone_textures(int side = kTextureSide, const Run& run = {});

// Dressed blocks of warm limestone in courses, two blocks across and six courses, with narrow sunken joints.
SurfaceMaps ashlar_textures(int side = kTextureSide, const Run& run = {});

// The same stone without joints: faint beds that run across, pores, stains.
SurfaceMaps limestone_textures(int side = kTextureSide, const Run& run = {});

// Heavy woven cloth of the given colour (linear light), three by three lozenges of a golden thread on it.
SurfaceMaps cloth_textures(glm::dvec3 colour, int side = kTextureSide, const Run& run = {});

// A single leaf, its tip up and its stalk at the lower edge, that fills the square but for a free rim. The
// colours go on beyond the outline, so that filters mix in nothing foreign. Alpha is the covered part of each
// texel; its mip levels are plain means (see keep_coverage).
Texture leaf_texture(int side = kTextureSide, const Run& run = {});

// A fence of woven wire, four by four diamonds, that repeats in both directions. Colours and alpha as above.
Texture fence_texture(int side = kTextureSide, const Run& run = {});

// A chain that hangs down the middle of the square, one link seen from the front and one from its side, that
// repeats downwards. Half a texture further down it is the same chain seen a quarter turn from there.
Texture chain_texture(int side = kTextureSide, const Run& run = {});

}  // namespace crevice
