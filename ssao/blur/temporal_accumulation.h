// Temporal accumulation: the AO map of a frame, mixed with what the frames before it found at the same places of
// the same surfaces. Each frame draws other random numbers, so the mean over n frames has 1 / sqrt(n) of the noise.
// Source: Nehab et al. 2007, "Accelerating real-time shading with reverse reprojection caching"; of AO, Mattausch,
//         Scherzer, Wimmer 2010, "High-quality screen-space ambient occlusion using temporal coherence"; the clamp:
//         Karis 2014, "High-quality temporal supersampling"
// In:     an AO map, the AoInputs it was computed from, its camera; what the last frame left
// Out:    AoHistory. Where nothing is taken over, the map itself, to the bit; background 1, of 0 frames
// Reach:  1 texel of this map and of the last frame's
// Differs from the sources: positions in the last frame are rounded to 1/256 of a texel, as texture units do, so
//         that a camera at rest mixes no texel with its neighbours. Depths are compared across the surface, not
//         along the view, so that slanted surfaces keep their history. Only the camera moves; the scene is at rest.
//         Even so, an occluder that comes into view darkens what stands beside it, and the history goes on telling
//         of the time before: a ghost, which only `longest` and `clamp` bound.
// Cost:   about 300 operations and 24 scattered reads a texel, 9 more with the clamp.
#pragma once

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

inline constexpr int kMostFramesOfHistory = 4096;
struct TemporalSettings {
    // [1, kMostFramesOfHistory]; so many frames count at most: a plain mean up to there, then each new frame has
    // 1 / longest of the whole and the past fades exponentially. 1: no history. More: less noise, longer ghosts.
    int longest = 1;
    // [0, 1], of the view depth: what lay further from the plane of a texel was another surface.
    float depth = 0.01f;
    // [-1, 1]; cosine: what faced another way was another surface.
    float normal = 0.8f;
    // The history is held within what this frame's nine texels around show: no ghosts where the map is smooth.
    bool clamp = false;
};

// Throws UsageError naming the first member out of its range.
void validate(const TemporalSettings& settings);

// What a frame leaves to the next one. All images are of the AO map's size.
struct AoHistory {
    Image<float> ao;      // accumulated accessibility
    Image<float> frames;  // how many are in it, this one too; between whole numbers where texels mix
    Image3 normal;        // view space, unit or 0
    Image<float> view_depth;
    ViewRays rays{glm::vec2(1), {}, true};  // of the picture
    Camera camera;

    bool empty() const { return ao.empty(); }  // before the first frame
};

// Throws UsageError when a setting is out of range, or the last frame's map had another size.
AoHistory temporal_accumulation(const Image<float>& ao, const AoInputs& inputs, const Camera& camera,
                                const AoHistory& last, const TemporalSettings& settings, const Run& run = {});

}  // namespace crevice
