// Ray-cast ambient occlusion as an AO map: a few rays a texel through the scene, so that what the screen does not show
// occludes as well.
// Source: X_Jun and Luna on ray casting; Keller & Heidrich 2001, "Interleaved sampling", for RayPattern::interleaved
// In:     RayScene with its origin at the eye; GBuffer, whose pixels the rays start at; AoInputs, whose texels are wanted
// Out:    accessibility in [0,1]: the share of the rays that meet nothing within the radius, to the power `exponent`;
//         background 1. Tiles: background, or open where no triangle can be met
// Rules:  a texel has the rays of one pixel, at half size of the nearest to the eye of the four around its centre.
//         Directions lie about its normal. Origins are lifted along that by what the position of a pixel
//         may be off: kRayLift of its largest coordinate, 1/256 of the pixel's size, the step of a 16-bit format.
// Reach:  radius, through the scene, whatever the screen shows
// Cost:   20 to 100 ns of one core a ray; open tiles one walk down the tree.
#pragma once

#include <cstdint>

#include "rasterizer/scene/camera.h"
#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"
#include "ssao/rays/hemisphere_directions.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

enum class RayPattern {
    independent,  // each texel has rays of its own
    interleaved,  // the texels of each square of kPatternSide share one well-spread set of rays, each has a part of it
};
inline constexpr int kPatternSide = 8;

inline constexpr float kRayLift = 0x1p-18f;

struct RayMapSettings {
    int samples = 8;      // [1, 256] rays a texel
    float radius = 0.5f;  // [0, 1e15] scene units; how far an occluder may be
    RayWeight weight = RayWeight::cosine;
    RayPattern pattern = RayPattern::independent;
    float exponent = 1;      // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;  // of the directions
    float ao_scale = 0.5f;   // 0.5 or 1; AO map size over picture size
};

// Throws UsageError naming the first member out of its range.
void validate(const RayMapSettings& settings);

// `inputs` were made of `gbuffer`.
AoMap ray_cast_map(const RayScene& scene, const Camera& camera, const GBuffer& gbuffer,
                   const AoInputs& inputs, const RayMapSettings& settings, const Run& run = {});
// Every ray of a texel as a sample; r is what it meets.
Explanation explain_ray_cast_map(const RayScene& scene, const Camera& camera, const GBuffer& gbuffer,
                                 const AoInputs& inputs, const RayMapSettings& settings, int x, int y);

}  // namespace crevice
