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
struct RayScene;

struct PrecisionLoss {
    const char* name;       // as passes.json has it
    std::size_t count = 0;  // of pixels, texels, triangles or vertices, as the name says
    std::string warning;    // one line with what to do; empty: worth a count, not a word
};

// Each kind once, those with count 0 too. `inputs` are those of the AO pass, empty where there was none, `rays` what it
// cast, or null.
std::vector<PrecisionLoss> precision_account(const Scene& scene, const Camera& camera,
                                             const ScreenGeometry& geometry, const GBuffer& gbuffer,
                                             const AoInputs& inputs, const RayScene* rays,
                                             const Method& method, const FrameSettings& settings,
                                             const Run& run);

}  // namespace crevice
