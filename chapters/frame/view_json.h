// What passes.json says of the view: the camera, its matrices, and in which space and unit each buffer stands. Enough for
// another program to draw the same picture and to compare it buffer by buffer.
#pragma once

#include <nlohmann/json.hpp>

#include "chapters/frame/scene_argument.h"

namespace crevice {

// {"eye", "target", "up", "projection", "fov_y" (degrees), "ortho", "near", "far"}: points in the scene's own coordinates, as
// --eye takes them; "ortho" is the picture's height in scene units and null in perspective, where "fov_y" counts.
nlohmann::ordered_json camera_json(const SceneArgument& argument, const Camera& camera);

// {"convention", "view", "projection"}: each matrix four rows of four. World space is that of the scene's own coordinates,
// for an OBJ with z negated, whatever origin the scene was moved to.
nlohmann::ordered_json matrices_json(const SceneArgument& argument, const Camera& camera, Size size);

// {"near", "far", "convention", "a", "b"}: which ndc depth stands for what.
nlohmann::ordered_json depth_json(const Camera& camera, Size size);

// {"space", "values", "background"} of a buffer that render writes.
nlohmann::ordered_json convention_json(const std::string& buffer, const Camera& camera);

// {"space", "unit", "offsets": [[x, y, z], ...]}; null where the method has none.
nlohmann::ordered_json samples_json(const Method& method, const MethodSettings& settings);

}  // namespace crevice
