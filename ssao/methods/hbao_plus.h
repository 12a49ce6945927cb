// HBAO without a horizon: each sample along rays over the screen counts by itself, by how squarely it lies over the
// surface and how near. It is what NVIDIA ships as HBAO+ and what the Unity notes list under the name of HBAO.
// Source: the Unity notes, section HBAO, whose listing is lync-li's Hbao.shader: accessibility is 1 - 2 / (1 - bias)
//         times the mean of saturate(n . V / |V| - bias) * saturate(1 - |V|^2 / radius^2).
// In:     view-space normals and view depth, background far away
// Out:    accessibility in [0,1] to the power `exponent`: an obscurance, not a share of rays
// Reach:  the radius around p on the screen, at p's depth, and a pixel
// Differs from the listing: directions lie evenly around the texel, turns are floats, the radius is projected by the
//         height of the picture, and near samples are normalised by their own length; `as_published` restores all
//         four. Lengths that the listing gives in units are given in radii. Rays are not cut at 128 pixels.
// Cost:   about 25 operations and one depth read a sample; normals from depth five reads a texel.
#pragma once

#include <cstdint>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// Where the rays go before they are turned.
enum class RayTable {
    even,    // evenly around the texel
    listed,  // the listing's table: three directions at 120 degrees, every further one straight up
};

// How a texel's turn is stored.
enum class TurnFormat {
    float32,
    unorm8,  // in an 8-bit texture, as listed: turns go up to 120 degrees, but negative cosines become 0, so that
             // beyond 90 degrees rays shorten instead
};

// What the radius is projected by.
enum class ProjectedBy {
    height,  // of the picture, as the field of view is vertical
    width,   // as listed: rays are longer by the picture's aspect, and most samples lie beyond the radius
};

// How samples count that lie nearer than an eighth of the radius.
enum class NearSamples {
    exact,    // like all others
    clamped,  // as listed, |V|^2 is at least 0.01 (of a radius of 0.8): contact shadows fade
};

// Where the texel's normal comes from.
enum class NormalSource {
    gbuffer,
    depth,  // the plane through the nearer neighbours' depths: no G-buffer is needed, and meshes show their facets
};

struct HbaoPlusSettings {
    int samples = 12;        // directions times steps, at most 64 directions
    int steps = 3;           // [1, 32]; of a direction
    float radius = 0.8f;     // [0, inf) scene units; what is further away does not occlude
    float bias = 0;          // [0, 0.9]; taken from the cosine between normal and sample, facets occlude less
    float exponent = 1;      // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;  // of the turns and shifts
    float ao_scale = 0.5f;   // 0.5 or 1; AO map size over picture size
    bool as_published = false;  // the listing, errors included: see spelt_out()
    NormalSource normals = NormalSource::gbuffer;

    RayTable table = RayTable::even;
    TurnFormat turns = TurnFormat::float32;
    ProjectedBy projected_by = ProjectedBy::height;
    NearSamples near_samples = NearSamples::exact;
};

// Throws UsageError naming the first member out of its range.
void validate(const HbaoPlusSettings& settings);

// The settings with the errors of `as_published` named one by one: listed, unorm8, width, clamped.
HbaoPlusSettings spelt_out(HbaoPlusSettings settings);

AoMap hbao_plus(const AoInputs& inputs, const HbaoPlusSettings& settings, const Run& run = {});
double hbao_plus_reach_px(const AoInputs& inputs, const HbaoPlusSettings& settings, double view_depth);
Explanation explain_hbao_plus(const AoInputs& inputs, const HbaoPlusSettings& settings, int x, int y);

}  // namespace crevice
