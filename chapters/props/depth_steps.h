// What a depth buffer keeps over the distance: ndc depth, and how far apart two depths are that a format can just tell apart.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/plot.h"
#include "rasterizer/draw/depth_precision.h"
#include "rasterizer/scene/camera.h"

namespace crevice {

// Steps and view depths in scene units, from the camera's near plane to its far plane.
PlotCurve step_curve(const std::string& name, Camera camera, DepthFormat format, bool reversed);

// The power of two from which on the step of a 16-bit float is larger than `length`, both in scene units.
double half_float_limit(double length);

// Ndc depth over view depths from 1 to 20.
PlotCurve ndc_curve(const CameraMatrices& matrices);
// Rows of: view depth, its ndc depth, and how far apart two depths are that a 24-bit buffer can just tell apart.
std::vector<std::vector<std::string>> d24_rows(const CameraMatrices& matrices);

}  // namespace crevice
