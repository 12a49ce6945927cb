// A level floor without anything on it, on which everything is open.
#pragma once

#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"

namespace crevice {

inline Scene bare_floor(const glm::dvec3& eye, const glm::dvec3& target) {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, grid_mesh(400, 400, 2, 2)), {0, 0, 0})};
    scene.camera.eye = eye;
    scene.camera.target = target;
    return scene;
}

}  // namespace crevice
