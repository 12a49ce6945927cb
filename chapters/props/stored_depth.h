// Depths as the tutorials store them, and what a stored depth does to the AO: for chapter 04.
#pragma once

#include <vector>

#include "chapters/props/depth_error_plot.h"
#include "rasterizer/draw/normal_depth.h"
#include "ssao/inputs/ao_inputs.h"

namespace crevice {

// View depth itself in a colour buffer (X_Jun), or ndc depth in the depth buffer (Luna).
struct DepthStorage {
    const char* name;
    DepthSource source;
    BufferFormat view_format;  // of view depths
    DepthFormat ndc_format;    // of ndc depths
};
inline constexpr DepthStorage kDepthStorages[] = {
    {"view z, 16-bit float", DepthSource::view_depth, BufferFormat::float16_toward_zero, DepthFormat::d32f},
    {"ndc depth, D16", DepthSource::ndc_depth, BufferFormat::float32, DepthFormat::d16},
    {"ndc depth, D24", DepthSource::ndc_depth, BufferFormat::float32, DepthFormat::d24},
    {"ndc depth, D32F", DepthSource::ndc_depth, BufferFormat::float32, DepthFormat::d32f}};

struct StoredDepthError {
    Image<float> off;  // rebuilt in float minus drawn view depth, scene units; background 0
    double most = 0;   // the largest, either way
    double most_of_z = 0, most_of_z2 = 0;  // the largest over z, over z^2
};
StoredDepthError stored_depth_error(const Scene& scene, Size size, const DepthStorage& storage);

// Five bare walls side by side at kWallDepths, turned a little so that each crosses some steps. Nothing is
// near any of them.
inline constexpr int kWalls = 5;
inline constexpr float kWallDepths[kWalls] = {25, 45, 65, 85, 105};
Scene bare_walls();

// Luna's AO of these walls as a depth buffer keeps them, and its mean along the middle of each.
struct WallAo {
    Image<float> ao;
    std::vector<double> means;
};
WallAo wall_ao(const DepthKind& kind);

// Naive: X_Jun's loop in C++, whose std::max(NaN, 0) is NaN; HLSL's is 0. AO of `inputs` before contrast,
// the background computed like any surface.
Image<float> ao_with_std_max(const AoInputs& inputs);

}  // namespace crevice
