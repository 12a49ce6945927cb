// Ground-truth ambient occlusion: in slices of the hemisphere the highest thing on either side closes all below it.
// Source: Jimenez et al. 2016, "Practical real-time strategies for accurate indirect occlusion", section 4; falloff,
//         noise, sample positions and levels of distant samples as in XeGTAO 1.30 (Intel).
// In:     view-space normals and view depth, background far away
// Out:    cosine-weighted accessibility in [0,1] of what lies within the radius, to the power `exponent`;
//         edge_denoiser() is XeGTAO's
// Reach:  radius_multiplier radii around p on the screen, at p's depth, those of a distant sample's cell more, and a
//         pixel
// Differs from both: GtaoForm::losses counts each slice by what it loses against an open plane, not by what it keeps.
//         Over all directions that is the same integral, but one slice is not 1 where nothing occludes, and here it is.
//         The other two forms count what is kept; what a few slices then keep above 1 is cut off, which XeGTAO does only
//         after its blur. Pixels beside a slice are moved into it (horizon_cosine()). Distant samples are pixels picked
//         by the rotated grid (depth_pyramid.h), one of XeGTAO's filters; its default, a mean weighed toward the
//         farthest depth, puts that mean where the sample fell, so that slanted planes close themselves. Its exponent
//         is 2.2. The paper's falloff is XeGTAO's.
// Cost:   about 60 operations and one depth read a sample, 120 a slice.
#pragma once

#include <cstdint>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// How slices are summed up, and what lets thin things occlude less.
enum class GtaoForm {
    losses,  // what each loses against an open plane
    // What each keeps, the paper's algorithm 1. A sample below the horizon lowers it by a share, `thickness`: the
    // heuristic of its section 4.3.
    paper,
    // What each keeps, a slice's length 5 % nearer to 1, and brighter where the radius is below 10 pixels.
    xegtao,
};

// XeGTAO's fitted constants: how far it looks for a radius, and over which part of that it fades.
inline constexpr float kGtaoReach = 1.457f, kGtaoFade = 0.615f;

struct GtaoSettings {
    int samples = 18;     // 4, 8, 12, 16, 18, 24 ... 192: slices times steps to both sides
    float radius = 0.5f;  // [0, inf) scene units; what is further away does not occlude
    GtaoForm form = GtaoForm::losses;
    float radius_multiplier = kGtaoReach;  // [0.3, 3]; how many radii away samples still count a little
    float falloff = kGtaoFade;  // [0, 1]; the outer part of that length over which they count less and less
    float step_power = 2;       // [1, 3]; steps lie denser near the texel the larger it is
    // [0, 0.7]; how much more a sample counts as far along the eye's ray (of GtaoForm::paper see there): thin things
    // occlude less
    float thickness = 0;
    // [2, 30]; a sample is read from level log2(its distance in pixels) minus this of the depth pyramid. XeGTAO: 3.3, for
    // the caches of a GPU. Smaller is coarser, and thin things are missed. 30: always from the picture itself, which on
    // a CPU is a fifth faster.
    float level_offset = 30;
    float exponent = 1;      // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;  // of the slices' turns and the steps' shifts
    float ao_scale = 0.5f;   // 0.5 or 1; AO map size over picture size
};

// Throws UsageError naming the first member out of its range.
void validate(const GtaoSettings& settings);

AoMap gtao(const AoInputs& inputs, const GtaoSettings& settings, const Run& run = {});
double gtao_reach_px(const AoInputs& inputs, const GtaoSettings& settings, double view_depth);
// The sample that is highest on its side of its slice takes all that the side loses. In the forms that count what is
// kept, one more at the texel itself tells by how much the open slice falls short of 1; that may be less than nothing.
Explanation explain_gtao(const AoInputs& inputs, const GtaoSettings& settings, int x, int y);

}  // namespace crevice
