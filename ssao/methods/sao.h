// Scalable ambient obscurance: taps along a spiral on the screen, the outer ones in a coarser copy of the
// depths, so that a large radius costs no more than a small one.
// Source: McGuire, Mara, Luebke 2012, "Scalable ambient obscurance" (HPG), and its published shader:
//         A = max(0, 1 - 5 intensity / (N r^6) sum of (r^2 - v.v)^3 max(0, (v.n - bias) / (epsilon + v.v)))
// In:     view-space normals and view depth, background far away
// Out:    accessibility in [0,1] to the power `exponent`; sao_denoiser() is the paper's blur
// Reach:  1.25 radii around p on the screen, at p's depth, and a pixel: a tap's cell is at most an eighth of
//         its distance wide, two where a picture of odd size ends; nothing beyond the radius in view space
//         counts
// Differs from the paper: bias, epsilon and intensity are lengths there; here all is counted in radii, so that
//         the unit of length does not matter (and r^6 neither overflows nor vanishes). A depth is put where it
//         was picked, not where the tap fell, which made planes seen at a slant close themselves
//         (SaoPlace::tapped). The turn of a texel's spiral is a hash without any pattern. Normals are those of
//         the G-buffer, not the planes of the depths' derivatives, and the mean of squares of four pixels by
//         derivatives is the blur's (sao_blur.h).
// Cost:   about 60 operations and one depth read a tap; the pyramid is a third of the picture.
#pragma once

#include <cstdint>

#include "rasterizer/lanes/approx_math.h"
#include "ssao/inputs/depth_pyramid.h"
#include "ssao/inputs/noise_tile.h"
#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// Where a depth from a coarse level is taken to lie.
enum class SaoPlace {
    picked,  // at the pixel that it is the depth of
    tapped,  // at the tap: the published shader's
};

struct SaoSettings {
    int samples = 11;     // [1, 64]; fewer is faster and noisier. The paper's spiral was chosen for 9 and 11
    int turns = 7;        // [1, 64]; of the spiral; one that divides `samples` puts taps behind each other
    float radius = 1;     // [0, inf) scene units; what is further away does not occlude
    float intensity = 1;  // [0, 64]; how much all that is found takes
    float bias = 0.01f;   // [0, 1] radii; what rises less over p's plane takes nothing
    float epsilon = 0.01f;  // [1e-8, 1] squared radii; caps what the nearest points take
    int levels = 5;         // [0, 5]; the coarsest level of depths: 0 reads every tap from the picture itself
    float exponent = 1;     // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;  // of the spirals' turns
    // The published shader's text: SaoPlace::tapped, and turns by 10 (3x xor (y + xy)), which no seed changes.
    bool as_published = false;
    float ao_scale = 0.5f;  // 0.5 or 1; AO map size over picture size
    SaoPlace place = SaoPlace::picked;
};

// Throws UsageError naming the first member out of its range.
void validate(const SaoSettings& settings);

// Where the taps lie before a texel's turn, in radii.
std::vector<Screen2<float>> sao_spiral(const SaoSettings& settings);
// The cosine or the sine of the angle by which the spiral of a texel is turned; the published one is that of the texel's
// column and row, here of the first 64.
NoiseTile sao_turn(const SaoSettings& settings, double SineCosine::*part);

AoMap sao(const AoInputs& inputs, const SaoSettings& settings, const Run& run = {});
double sao_reach_px(const AoInputs& inputs, const SaoSettings& settings, double view_depth);
Explanation explain_sao(const AoInputs& inputs, const SaoSettings& settings, int x, int y);

}  // namespace crevice
