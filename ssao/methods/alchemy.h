// Alchemy ambient obscurance: what lies around p on the screen takes from it as squarely as it lies over p and
// as near as it is.
// Source: McGuire et al. 2011, "The Alchemy screen-space ambient obscurance algorithm" (HPG):
//         A = max(0, 1 - (2 sigma / s) sum of max(0, v.n - z beta) / (v.v + epsilon))^k. AlchemyTaps::sphere
//         places the taps as ScalableAO of Unity's Post-Processing v2 does.
// In:     view-space normals and view depth, background far away
// Out:    accessibility in [0,1] to the power `exponent`
// Reach:  the radius around p on the screen, at p's depth, and a pixel; AlchemyTaps::sphere: the radius in view
//         space
// Differs from the paper: sigma is a length and epsilon a squared length there; here both are counted in radii,
//         so that the unit of length does not matter. Taps share a spiral whose rings are strata of the disk;
//         the paper's are loose points. The background takes nothing.
// Differs from Unity: it leaves out the 2 (intensity .5 is its 1), has bias .002 and epsilon .0016 (1e-4 at its
//         radius of .25), turns by interleaved gradient noise, and raises the occlusion, not the accessibility,
//         to the power .6, which no exponent here does.
// Cost:   about 40 operations and one depth read a tap.
#pragma once

#include <cstdint>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// Where the taps of a texel lie.
enum class AlchemyTaps {
    disk,    // evenly in a disk on the screen, as wide as the radius at p's depth
    sphere,  // where points of the half ball over p are seen: fewer of them far from p on the screen
};

struct AlchemySettings {
    int samples = 12;     // [1, 64]; fewer is faster and noisier
    float radius = 0.5f;  // [0, inf) scene units; how far from p the taps lie
    float intensity = 1;  // [0, 64]; the paper's sigma over the radius: how much all that is found takes
    // [0, 1]; the paper's beta: what rises less than this times the view depth over p's plane takes nothing. It
    // grows with depth as the errors of depth do.
    float bias = 1e-4f;
    float epsilon = 4e-4f;   // [1e-8, 1] squared radii; caps what the nearest points take
    float exponent = 1;      // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;  // of the taps' turns and shifts
    float ao_scale = 0.5f;   // 0.5 or 1; AO map size over picture size
    AlchemyTaps taps = AlchemyTaps::disk;
};

// Throws UsageError naming the first member out of its range.
void validate(const AlchemySettings& settings);

AoMap alchemy(const AoInputs& inputs, const AlchemySettings& settings, const Run& run = {});
double alchemy_reach_px(const AoInputs& inputs, const AlchemySettings& settings, double view_depth);
Explanation explain_alchemy(const AoInputs& inputs, const AlchemySettings& settings, int x, int y);

}  // namespace crevice
