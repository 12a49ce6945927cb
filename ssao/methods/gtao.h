// Ground-truth ambient occlusion: in slices of the hemisphere the highest thing on either side closes all below it.
// Source: Jimenez et al. 2016, "Practical real-time strategies for accurate indirect occlusion", section 4; falloff,
//         noise and sample positions as in XeGTAO 1.30 (Intel).
// In:     view-space normals and view depth, background far away
// Out:    cosine-weighted accessibility in [0,1] of what lies within the radius, to the power `exponent`
// Reach:  kGtaoReach radii around p on the screen, at p's depth, and a pixel
// Differs from both: each slice is counted by what it loses against an open plane, not by what it keeps. Over all
//         directions that is the same integral, but one slice is not 1 where nothing occludes, and here it is. Pixels
//         beside a slice are moved into it (horizon_cosine()). XeGTAO's depth pyramid, its 5 % for short normals and
//         its fade below 10 pixels are left out; its exponent is 2.2.
// Cost:   about 60 operations and one depth read a sample, 120 a slice.
#pragma once

#include <cstdint>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

struct GtaoSettings {
    int samples = 18;     // 4, 8, 12, 16, 18, 24 ... 192: slices times steps to both sides
    float radius = 0.5f;  // [0, inf) scene units; what is further away does not occlude
    float thickness =
        0;  // [0, 0.7]; how much more a sample counts as far along the eye's ray: thin things occlude less
    float exponent = 1;      // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;  // of the slices' turns and the steps' shifts
    float ao_scale = 0.5f;   // 0.5 or 1; AO map size over picture size
};

// XeGTAO's fitted constants: how far it looks for a radius, and over which part of that it fades.
inline constexpr float kGtaoReach = 1.457f, kGtaoFade = 0.615f;

// Throws UsageError naming the first member out of its range.
void validate(const GtaoSettings& settings);

AoMap gtao(const AoInputs& inputs, const GtaoSettings& settings, const Run& run = {});
double gtao_reach_px(const AoInputs& inputs, const GtaoSettings& settings, double view_depth);
// The sample that is highest on its side of its slice takes all that the side loses.
Explanation explain_gtao(const AoInputs& inputs, const GtaoSettings& settings, int x, int y);

}  // namespace crevice
