// What can be set of the tutorials' AO pass: its lengths, and each of its artifacts with the cure beside it.
#pragma once

#include <cstdint>

#include "rasterizer/lanes/half.h"
#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// What a texel's 14 offsets are mirrored at.
enum class RandomVectors {
    unit,  // the random map's vectors, normalised
    raw,   // the same as the map holds them: no mirrors, and samples up to five radii away
    none,  // nothing: every texel looks in the same 14 directions, which shows as bands
};

// The side of the surface that an offset along it belongs to: HLSL's sign(0) is 0, and the sample falls onto
// its own texel.
enum class SignOfZero { plus, zero };

struct LunaSettings {
    int samples = 14;         // [1, 14]; fewer is faster and noisier
    float radius = 0.5f;      // [0, inf) scene units; how far from p the samples lie
    float fade_start = 0.2f;  // [0, inf) scene units; occluders up to this far in front of p count fully
    // [fade_start, inf) scene units; occluders further in front of p than this do not count.
    float fade_end = 2.0f;
    float epsilon = 0.05f;      // [0, inf) scene units; occluders less than this in front of p do not count
    float exponent = 4;         // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;     // of the offset lengths and the random map
    bool as_published = false;  // the tutorial's text, traps included: see spelt_out()
    float ao_scale = 0.5f;      // 0.5 or 1; AO map size over picture size
    BufferFormat format = BufferFormat::float32;  // of the AO map

    // Of the samples.
    RandomVectors random_vectors = RandomVectors::unit;
    SignOfZero sign_of_zero = SignOfZero::plus;
    bool self_occlusion_test = true;  // false: dp is 1, only the difference in depth decides

    // Of what they are compared with.
    DepthSource depth_source = DepthSource::view_depth;
    MapBorder border = MapBorder::far;
    TexelCentre texel_centre = TexelCentre::exact;
    EdgeTexels edge_texels = EdgeTexels::nearest;
    SkyDepth sky_depth = SkyDepth::finite;
};

// Throws UsageError naming the first member out of its range.
void validate(const LunaSettings& settings);

// The settings with the traps of `as_published` named one by one: random vectors raw (unless there are none),
// the sign of 0 zero, edge texels mixed, the sky's depth as stored.
LunaSettings spelt_out(LunaSettings settings);

// Whether any switch is not at its cure; either depth source is one.
bool shows_artifacts(const LunaSettings& settings);

// How the settings want the G-buffer fetched.
AoFetch ao_fetch(const LunaSettings& settings, bool point_normals);

}  // namespace crevice
