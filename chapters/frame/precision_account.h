// What numbers cost a frame: how many pixels, texels and vertices lost precision that matters to what is shown. Counted in
// every frame; where nothing was lost nothing is said.
#pragma once

#include <string>
#include <vector>

#include "rasterizer/draw/normal_depth.h"
#include "ssao/inputs/ao_inputs.h"

namespace crevice {

struct FrameSettings;
struct Method;
struct MethodSettings;
struct RayScene;

struct PrecisionLoss {
    const char* name;       // as passes.json has it
    std::size_t count = 0;  // of pixels, texels, triangles or vertices, as the name says
    std::string warning;    // one line with what to do; empty: worth a count, not a word
};

// How many vertices are too far from the origin for a length (rasterizer/scene/far_vertices.h). It follows from the shapes of
// the scene and the length alone, so frames of one scene keep it.
struct FarVertices {
    double length = 0;  // scene units; 0: not counted yet
    std::size_t count = 0;
};
// Of what these settings tolerate; `known` itself where that is of the same length, or they tolerate anything.
FarVertices far_vertices(const Scene& scene, const Method& method, const MethodSettings& settings,
                         const FarVertices& known, const Run& run);

// What the account is of.
struct DrawnForAccount {
    const Scene& scene;
    const Camera& camera;
    const ScreenGeometry& geometry;
    const GBuffer& gbuffer;
    const AoInputs& inputs;    // of the AO pass, empty where there was none
    const RayScene* rays;      // that it cast, or null
    std::size_t far_vertices;  // of far_vertices(); of any value where there was no AO pass
};

// Each kind once, those with count 0 too.
std::vector<PrecisionLoss> precision_account(const DrawnForAccount& drawn, const Method& method,
                                             const FrameSettings& settings, const Run& run);

}  // namespace crevice
