// A vertex bake as an AO map: accessibility cast once at the vertices of a scene, shown by a camera as a renderer shows
// it, interpolated over each triangle.
// Source: Luna, BuildVertexAmbientOcclusion; X_Jun on ray casting; here from the corners (vertex_ao.h)
// In:     Scene, its RayScene with the eye as origin, Camera; AoInputs, whose texels are wanted
// Out:    accessibility in [0,1] to the power `exponent`; background 1
// Rules:  rays lie about the triangles' own normals, so that a smooth surface of few triangles does not darken itself.
//         The bake is given where it was made before; it depends on the scene, on radius, weight, samples and seed alone, up
//         to the rounding of positions relative to the eye.
// Reach:  radius, through the scene; of the G-buffer only which texels are background
// Differs from rays at the pixels: what happens between vertices is not known, so meshes must be fine where shadows are.
// Cost:   the bake: samples * 50 to 150 ns of one core a vertex; a frame: one ray a texel.
#pragma once

#include <cstdint>

#include "rasterizer/scene/camera.h"
#include "ssao/bakes/vertex_ao.h"
#include "ssao/inputs/ao_inputs.h"
#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

struct VertexBakeSettings {
    int samples = 64;     // [1, 65536] rays a vertex
    float radius = 0.5f;  // [0, 1e15] scene units; how far an occluder may be
    RayWeight weight = RayWeight::cosine;
    float exponent = 1;      // [0, 64]; contrast: accessibility is raised to it
    std::uint32_t seed = 1;  // of the directions
    float ao_scale = 1;      // 0.5 or 1; AO map size over picture size
};

// Throws UsageError naming the first member out of its range.
void validate(const VertexBakeSettings& settings);

VertexAo baked_vertices(const Scene& scene, const RayScene& rays, const VertexBakeSettings& settings,
                        const Run& run = {});

AoMap vertex_bake(const Scene& scene, const Camera& camera, const RayScene& rays, const AoInputs& inputs,
                  const VertexAo& baked, const VertexBakeSettings& settings, const Run& run = {});

// The corners of the triangle that texel (x, y) shows as samples: what each takes from the most open one.
Explanation explain_vertex_bake(const Scene& scene, const Camera& camera, const RayScene& rays,
                                const AoInputs& inputs, const VertexAo& baked,
                                const VertexBakeSettings& settings, int x, int y);

}  // namespace crevice
