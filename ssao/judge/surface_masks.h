// What kind of place each pixel shows: sky, the neighbourhood of a depth edge, of a crease, or flat surface.
// An error over the whole picture hides what happens at edges; these tell it apart.
// In:     GBuffer with float32 depth (rounding to half floats looks like steps), the camera it was drawn with
// Out:    one kind a pixel, so the kinds are disjoint and cover the picture
// Steps:  two neighbours, side by side or one above the other, have a step between them when one shows sky
//         and the other not, or when their surfaces do not meet: each is continued to the other as the plane
//         through it and the pixel behind it. On a plane 1 / view depth is linear in screen x and y
//         (orthographic: view depth), so a floor has no step however grazing, and no curved surface has one.
//         Where the two planes cross between the pixels the surfaces meet there.
// Folds:  neighbours without a step whose normals differ.
// Reach:  kMaskReach_px
// Cost:   about 60 operations a pixel.
#pragma once

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

enum class SurfaceKind : std::uint8_t {
    sky,     // view depth is not finite
    edge,    // within kMaskReach_px of a step
    crease,  // else within kMaskReach_px of a fold
    flat,    // the rest, smoothly curved surfaces too
};

// Pixels on either side of a step or fold.
inline constexpr int kMaskReach_px = 3;
// A gap in depth is a step when it is wider than this many pixels are at the nearer of the two.
inline constexpr double kStepGap_px = 4;
// Normals differ when the angle between them has a smaller cosine: 15 degrees.
inline constexpr float kFoldCosine = 0.9659258f;

Image<SurfaceKind> surface_kinds(const GBuffer& gbuffer, const Camera& camera);

// A part of the picture that errors are told over.
enum class Region { all, surface, edge, crease, flat };
inline constexpr Region kRegions[] = {Region::all, Region::surface, Region::edge, Region::crease,
                                      Region::flat};
const char* region_name(Region region);

// Whether pixels of this kind belong to the region; `surface` is everything but sky.
bool contains(Region region, SurfaceKind kind);

// 1 inside the region, 0 outside.
Image<std::uint8_t> region_mask(const Image<SurfaceKind>& kinds, Region region);

}  // namespace crevice
