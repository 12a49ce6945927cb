// Points in the hemisphere over each texel, counted by what lies in front of them: the share of the hemisphere
// that is filled.
// Source: LearnOpenGL, chapter "SSAO" (de Vries), as Chinese notes retell it: 64 points, a 4 x 4 tile of
//         turns.
// In:     view-space normals and view depth, background far away
// Out:    accessibility in [0,1]: 1 - (1/N) sum of range checks of the hidden points, to the power `exponent`
// Reach:  radius in view space around p
// Differs from the source: its errata are settings whose defaults are the cures; `as_published` sets them
//         together. The surface in front of a point must also lie over p's own plane (SelfOcclusion::plane).
//         The eye sees p and the point from above that plane, so whatever hides the point lies above it, too;
//         only the pixel's centre, where its depth was taken, does not, and on grazing planes that error is
//         more than any bias in depth. A point in front of the near plane is rejected. What is counted is
//         volume, not directions: it does not tend to ray-cast accessibility.
// Cost:   about 60 operations and one depth read a sample.
#pragma once

#include <cstdint>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"
#include "ssao/methods/hemisphere_samples.h"

namespace crevice {

// What the background counts as.
enum class BackgroundPosition {
    far,  // nothing
    // What the position buffer is cleared to, (0, 0, 0), lies in front of everything: silhouettes darken. With
    // MapBorder::far that begins at the border of the picture.
    at_eye,
};

struct HemisphereSettings {
    int samples = 64;           // [1, 256]; fewer is faster and noisier
    float radius = 0.5f;        // [0, inf) scene units; how far from p the points lie
    float bias = 0.025f;        // [0, inf) scene units; how much nearer an occluder must be. 0: acne
    float exponent = 1;         // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;     // of the points and the turns
    bool as_published = false;  // the errata of the text in one: see spelt_out()
    float ao_scale = 1;         // 0.5 or 1; AO map size over picture size

    // Of what the points are compared with: without the range check what is far in front counts like what is
    // near, dark rims. The notes hold it for the cure of self-occlusion, which is the bias.
    bool range_check = true;
    SelfOcclusion self_occlusion = SelfOcclusion::plane;
    BackgroundPosition background = BackgroundPosition::far;
    // edge: clamped, as published; what recedes out of the picture is closed by its own outermost pixels.
    MapBorder border = MapBorder::far;

    // Of the points. Normals that are not made unit are those of the filtered buffer: at half size the mean of
    // unlike ones is short, the hemisphere flat.
    bool unit_normals = true;
    TurnVectors turn_vectors = TurnVectors::circle;
    // true: the tile is laid over the map as if that were 1024 texels wide and high, and the blur of four
    // texels no longer evens it out.
    bool turns_for_1024 = false;
};

// Throws UsageError naming the first member out of its range.
void validate(const HemisphereSettings& settings);

// The settings with the errata of `as_published` named one by one: self-occlusion by depth alone, the
// background at the eye, the border clamped, normals as they are, turns from a square and for a map of 1024
// texels.
HemisphereSettings spelt_out(HemisphereSettings settings);

// How much an occluder counts, in [0,1], that lies `distance` in front of p or behind it along the view: fully
// within the radius, and smoothly less beyond.
template <class F>
CREVICE_INLINE F range_weight(F distance, float radius) {
    const F apart = absolute(distance);
    const auto beyond = apart > F(radius);
    return select(beyond, smooth_step(F(radius) / select(beyond, apart, F(1))), F(1));
}

AoFetch hemisphere_fetch(const HemisphereSettings& settings);
// SampleOffsets::vectors of the settings' samples.
std::vector<glm::vec3> hemisphere_offsets(const HemisphereSettings& settings);

AoMap hemisphere_ao(const AoInputs& inputs, const HemisphereSettings& settings, const Run& run = {});
double hemisphere_reach_px(const AoInputs& inputs, const HemisphereSettings& settings, double view_depth);
Explanation explain_hemisphere(const AoInputs& inputs, const HemisphereSettings& settings, int x, int y);

}  // namespace crevice
