// Horizon-based ambient occlusion: along rays over the screen the highest thing closes all below it, each rise of the
// horizon counting as much as the thing that makes it.
// Source: Bavoil & Sainz 2008, "Image-space horizon-based ambient occlusion" (SIGGRAPH talk and the NVIDIA SDK 10
//         sample): A = 1 - mean over the directions of the sum of W(r) (sin h - sin of the horizon before).
// In:     view-space normals and view depth, background far away
// Out:    accessibility in [0,1] of what lies within the radius, every direction of the hemisphere counting the same
//         (not the cosine), to the power `exponent`
// Reach:  the radius around p on the screen, at p's depth, and a pixel
// Differs from the source: elevations are measured against the eye's ray, on which no plane that can be seen turns
//         away, not against the view axis; a direction keeps its angle above the plane beneath it, where the source
//         snaps the tangent to pixels instead; 4 x 4 turns and shifts are spread evenly, not drawn freely.
// Cost:   about 60 operations and one depth read a sample, 40 a direction.
#pragma once

#include <cstdint>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// What elevations are measured against.
enum class Zenith {
    ray,   // the eye's ray through the texel
    axis,  // the view axis, the source's: towards the sides of the picture steep planes close themselves
};

struct HbaoSettings {
    int samples = 24;     // directions times steps, at most 64 directions
    int steps = 4;        // [1, 32]; of a direction; the more, the fewer thin things are missed
    float radius = 0.5f;  // [0, inf) scene units; what is further away does not occlude
    // [0, 89.9] degrees; what is lower above the tangent plane does not occlude: coarse meshes lose their facets,
    // creases their depth.
    float bias = 30;
    float exponent = 1;      // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;  // of the turns and shifts
    float ao_scale = 0.5f;   // 0.5 or 1; AO map size over picture size
    Zenith zenith = Zenith::ray;
};

// Throws UsageError naming the first member out of its range.
void validate(const HbaoSettings& settings);

AoMap hbao(const AoInputs& inputs, const HbaoSettings& settings, const Run& run = {});
double hbao_reach_px(const AoInputs& inputs, const HbaoSettings& settings, double view_depth);
// A sample takes what it raises the horizon of its direction by.
Explanation explain_hbao(const AoInputs& inputs, const HbaoSettings& settings, int x, int y);

}  // namespace crevice
