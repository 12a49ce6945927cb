// The camera under mouse and keys: each motion takes a camera and gives the one after it.
// Space: world (left-handed, y up); angles in radians
#pragma once

#include "chapters/frame/scene_argument.h"
#include "rasterizer/scene/camera.h"

namespace crevice {

// Short of straight up and down, where no direction would be sideways.
inline constexpr double kSteepest_rad = 1.55;

// Round the target, which stays in the middle of the picture: positive angles carry the eye to the left and up, so that
// the scene follows a mouse that moves right and down.
Camera orbited(const Camera& camera, double sideways_rad, double upward_rad);

// The eye stays and looks further to the right and up.
Camera looked_aside(const Camera& camera, double sideways_rad, double upward_rad);

// Eye and target together, in parts of their distance, along the camera's own right, up and forward.
Camera moved(const Camera& camera, const glm::dvec3& right_up_forward);

// The eye comes nearer to the target (factor < 1) or goes away from it; without perspective the picture's height follows.
Camera zoomed(const Camera& camera, double factor);

// The flags that give this camera again: eye and target in the scene's own coordinates with seven digits, a step of which
// is below a thousandth of a pixel; the height without perspective; the others as `flags` has them.
CameraFlags flags_of(const SceneArgument& scene, const Camera& camera, const CameraFlags& flags);

}  // namespace crevice
