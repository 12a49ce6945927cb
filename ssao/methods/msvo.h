// Multi-scale volumetric obscurance: how much of a ball around p lies in front of what the depths show, at four
// sizes of the ball, from depths alone.
// Source: MiniEngine (Microsoft, SSAO.cpp and its shaders Ao*.hlsl) and its port in Unity's Post-Processing v2
//         (MultiScaleVO); the ball as chords along the eye's rays by Loos and Sloan 2010, "Volumetric
//         obscurance".
// In:     view depth of the pixel under each texel's centre. No normals
// Out:    accessibility in [0,1] to the power `exponent`: what the scales leave open, upsampled and combined
// Reach:  the radius across p's view, at p's depth, and the cells that a texel is upsampled from: 7 texels
// Differs from the sources: their balls have fixed sizes on the screen (40, 80, 160 and 320 pixels in radius),
//         so that what darkens a place depends on how far it is from the eye. Here the largest ball has the
//         radius, each next one half of it. Chords are lengths in scene units, so that an orthographic picture
//         works too, and depths are compared relative to p's when scales are upsampled, not to the far plane.
//         Their blur between scales is left out: it smooths the pattern of their taps, which lie four texels
//         apart. So are the de-interleaved copies of the depths, which spare a GPU's caches: all taps read the
//         map's own. Scales are upsampled one by one, so that one can tell what each takes, and the two
//         coarsest have a grid in common. A pair of chords opens no more than a plane, and one that leaves the picture
//         counts as one (MsvoPairs::all is theirs). The sky is infinitely far away.
// Cost:   36 reads of depth and about 400 operations a texel and scale; the coarser ones have 1/4, 1/16 and
//         1/16 of the texels.
#pragma once

#include <cstdint>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

inline constexpr int kMsvoScales = 4, kMsvoTaps = 36;

// What a texel keeps of what its scales leave open.
enum class MsvoCombine {
    product,  // the sources'
    minimum,  // the darkest scale alone
};

// Up to what a pair of chords may be open.
enum class MsvoPairs {
    // To what a plane leaves of it.
    plane,
    // To all of it; only the ball as a whole is open up to what a plane leaves: the sources'. What lies behind
    // an edge then makes up for what rises on the other side of p, and floors seen at a grazing angle stay
    // open.
    all,
};

struct MsvoSettings {
    int samples = 144;    // 36, 72, 108 or 144: 36 a scale; with fewer scales the smallest balls are missing
    float radius = 2;     // [0, inf) scene units; of the largest ball
    float intensity = 1;  // [0, 4]; how much of what a scale found it takes
    // [1, 10]; Unity's thickness modifier: how many chords in front of the ball something still occludes. More
    // is darker, and puts dark halos around what stands in front.
    float thickness = 1;
    float exponent = 1;      // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 0;  // of the texel that stands for a cell; 0: the upper left one, the sources'
    float ao_scale = 0.5f;   // 0.5 or 1; AO map size over picture size
    MsvoCombine combine = MsvoCombine::product;
    MsvoPairs pairs = MsvoPairs::plane;
};

// Throws UsageError naming the first member out of its range.
void validate(const MsvoSettings& settings);

// `inputs` as depth_inputs() makes them.
AoMap msvo(const AoInputs& inputs, const MsvoSettings& settings, const Run& run = {});
double msvo_reach_px(const AoInputs& inputs, const MsvoSettings& settings, double view_depth);
// The pairs of taps of the finest scale, each as the nearer of its two points; then a sample a coarser scale.
Explanation explain_msvo(const AoInputs& inputs, const MsvoSettings& settings, int x, int y);

}  // namespace crevice
