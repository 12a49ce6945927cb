// The Unity notes' first SSAO: points in the hemisphere over each texel, their depth against the depth map's.
// Source: the Unity notes, section 4.2: "SSAO" and its improvements
// In:     view-space normals and view depth, background far away
// Out:    accessibility in [0,1]: 1 - (1/N) sum of range * weight of the hidden points, to the power `exponent`
// Reach:  radius in view space around p
// Differs from the source: what its listings get wrong are settings whose defaults are the cures;
//         `as_published` sets them together. Range and bias, which the source takes as shares of the far
//         plane's distance, are shares of the radius, so that they mean the same whatever the far plane. The
//         surface in front of a point must also lie over p's own plane (SelfOcclusion::plane; hemisphere.h
//         tells why). A point in front of the near plane is rejected. The noise texture, which the notes do
//         not give, is a tile of 4 x 4 unit vectors.
// Cost:   about 65 operations and one depth read a sample.
#pragma once

#include <cstdint>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"
#include "ssao/methods/hemisphere_samples.h"

namespace crevice {

// Which depth is compared with that of the surface a point falls onto.
enum class ComparedDepth {
    point,  // the point's own: whether it is hidden
    // p's, as published: whether the surface is nearer than p. Half of a plane at a slant is nearer, which
    // SelfOcclusion::plane hides.
    centre,
};

// What is summed up, and what the map holds of it.
enum class CountedPoints {
    hidden,  // the map holds 1 - the mean
    // As in the notes' whole listing, the map holds the mean. Points that the range or the weight rules out are
    // not counted as open, and darken.
    open,
    // As in the notes' text: counts the hidden, and multiplies the picture by their mean. What is open turns
    // black.
    hidden_as_open,
};

struct UnitySettings {
    int samples = 64;     // [1, 64]; fewer is faster and noisier
    float radius = 0.5f;  // [0, inf) scene units; how far from p the points lie
    // [0, inf) radii; surfaces further than this from p along the view do not count. 1e30: no range check, dark
    // rims.
    float range = 1;
    float bias = 0.05f;         // [0, 1] radii; how much nearer an occluder must be. 0: acne
    float exponent = 1;         // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;     // of the points and the turns
    bool as_published = false;  // the errata of the text in one: see spelt_out()
    float ao_scale = 1;         // 0.5 or 1; AO map size over picture size

    // The text's improvements.
    bool random_basis = true;  // false: every texel's points lie the same way, bands
    // Points less than 0.2 radii away across the view count less: they fall onto p's own pixel.
    bool weight_smoothing = true;

    // What the listings get wrong.
    ComparedDepth compared_depth = ComparedDepth::point;
    SelfOcclusion self_occlusion = SelfOcclusion::plane;
    CountedPoints counted_points = CountedPoints::hidden;
    // true: a normal whose z has the other sign than the positions' lets the points lie in a mirrored
    // hemisphere, of what faces the eye behind the surface: it occludes itself, which SelfOcclusion::plane
    // hides.
    bool mirrored_z = false;
    // true: coordinates on the screen are divided by the projected z without its constant part instead of by w,
    // and drawn together by (far - near) / (far + near).
    bool divided_by_z = false;
};

// Throws UsageError naming the first member out of its range.
void validate(const UnitySettings& settings);

// The settings with the errata of `as_published` named one by one: p's depth compared, self-occlusion by depth
// alone, the hidden points shown as open, mirrored and divided by z.
UnitySettings spelt_out(UnitySettings settings);

// SampleOffsets::vectors of the settings' samples, not yet mirrored.
std::vector<glm::vec3> unity_offsets(const UnitySettings& settings);

AoMap unity_ao(const AoInputs& inputs, const UnitySettings& settings, const Run& run = {});
double unity_reach_px(const AoInputs& inputs, const UnitySettings& settings, double view_depth);
Explanation explain_unity(const AoInputs& inputs, const UnitySettings& settings, int x, int y);

}  // namespace crevice
