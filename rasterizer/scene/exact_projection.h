// The camera's projection as it is before camera_matrices() rounds it to float.
#pragma once

#include <glm/mat4x4.hpp>

#include "rasterizer/scene/camera.h"

namespace crevice {

// CameraMatrices::clip_from_relative in double. `camera` must be valid.
glm::dmat4 clip_from_relative(const Camera& camera, Size size);

}  // namespace crevice
