// One small scene with every kind of edge.
#pragma once

#include <utility>

#include "scenes/shapes.h"
#include "tests/tools/small_scenes.h"

namespace crevice {

// A floor, a wall behind its left half, a box and a sphere on it, and sky: every kind of edge in few pixels.
// About 6 units deep.
inline Scene still_life() {
    const auto moved = [](Mesh mesh, glm::vec3 by) {
        for (glm::vec3& p : mesh.positions) p += by;
        return mesh;
    };
    const Mesh floor = moved(grid_mesh(8, 8, 9, 9), {0, -1, 4});
    const Mesh wall = quad_mesh({glm::vec3(-4, 2, 6), {0, 2, 6}, {0, -1, 6}, {-4, -1, 6}}, {0, 0, -1});
    Scene scene = scene_of({floor, wall, moved(box_mesh({1, 1, 1}), {-1, -0.5f, 4}),
                            moved(sphere_mesh(0.5, 16, 8), {0.75f, -0.5f, 3.25f})});
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 100;
    return scene;
}

}  // namespace crevice
