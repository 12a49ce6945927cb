// How far apart two depths are that a format can just tell apart, over the distance.
#pragma once

#include <string>

#include "chapters/notebook/plot.h"
#include "rasterizer/draw/depth_precision.h"
#include "rasterizer/scene/camera.h"

namespace crevice {

// Steps and view depths in scene units, from the camera's near plane to its far plane.
PlotCurve step_curve(const std::string& name, Camera camera, DepthFormat format, bool reversed);

// The power of two from which on the step of a 16-bit float is larger than `length`, both in scene units.
double half_float_limit(double length);

}  // namespace crevice
