// Visibility bitmask: each slice of the hemisphere is 32 sectors, and what a sample closes begins at its front and ends
// at its back, a fixed thickness behind. So light passes behind a thin thing, where a horizon closes all below it.
// Source: Therrien, Levesque & Gilet 2023, "Screen space indirect lighting with visibility bitmask", arXiv 2301.11376;
//         slices, noise and sample positions as GTAO has them (slices.h).
// In:     view-space normals and view depth, background far away
// Out:    accessibility in [0,1] of what lies within the radius, to the power `exponent`; cosine-weighted with
//         Sectors::cosine
// Reach:  the radius around p on the screen, at p's depth, and a pixel
// Differs from the paper: sectors have equal shares of the cosine-weighted integral instead of equal angles, and one is
//         closed when its middle is covered, instead of when it is touched; settings restore both. Samples further
//         away than the radius do not count. No light is gathered. A direction keeps its angle above the plane beneath
//         it, or pixels beside a slice would let tilted planes close themselves.
// Limit:  what lies between the few samples of a slice is missed; a thickness above the true one makes up for it.
// Cost:   one depth read a sample and about 70 operations, 130 where anything stands above the open plane; 60 a slice.
#pragma once

#include <cstdint>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// What the 32 sectors of a slice have in common.
enum class Sectors {
    cosine,  // the light that comes through: each is 1/32 of the slice's cosine-weighted integral
    angle,   // the angle, as published: slices are averaged as they are, whatever light they let through
};

// Which sectors a sample closes.
enum class ClosedSectors {
    middle,   // those whose middle it covers: right on the average, and a plane does not close itself
    touched,  // all that it touches, as published: everything is up to two sectors too wide
};

struct VbaoSettings {
    int samples = 18;     // 4, 8, 12, 16, 18, 24 ... 192: slices times steps to both sides
    float radius = 0.5f;  // [0, inf) scene units; what is further away does not occlude
    // [0, inf) scene units; how far behind its front a thing ends, along the eye's ray. 0: nothing occludes; 1e30:
    // nothing ends, as with a horizon.
    float thickness = 0.125f;
    float exponent = 1;      // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;  // of the slices' turns and the steps' shifts
    float ao_scale = 0.5f;   // 0.5 or 1; AO map size over picture size
    Sectors sectors = Sectors::cosine;
    ClosedSectors closed = ClosedSectors::middle;
};

// Throws UsageError naming the first member out of its range.
void validate(const VbaoSettings& settings);

AoMap vbao(const AoInputs& inputs, const VbaoSettings& settings, const Run& run = {});
double vbao_reach_px(const AoInputs& inputs, const VbaoSettings& settings, double view_depth);
// A sample takes the sectors that none before it has closed.
Explanation explain_vbao(const AoInputs& inputs, const VbaoSettings& settings, int x, int y);

}  // namespace crevice
