// Scenes of planes for the methods that step across the screen: a slanted plane, a floor with a wall.
#pragma once

#include <string>

#include "rasterizer/draw/normal_depth.h"
#include "ssao/inputs/ao_inputs.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

namespace crevice {

// A plane without end through (0, 0, 5) that the eye sees under `degrees` from head-on.
inline Scene tilted_plane(float degrees) {
    const float angle = glm::radians(degrees), far = 40;
    const glm::vec3 across(far, 0, 0), up(0, std::cos(angle) * far, std::sin(angle) * far);
    const glm::vec3 centre(0, 0, 5), n = glm::normalize(glm::vec3(0, std::sin(angle), -std::cos(angle)));
    Scene scene = scene_of({quad_mesh(
        {centre - across + up, centre + across + up, centre + across - up, centre - across - up}, n)});
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 200;
    return scene;
}

// A floor and on it, 6 away, a wall of some height that faces the eye; above it the sky.
inline Scene wall_on_floor(float height) {
    const float far = 40, low = -1, z = 6;
    const Mesh floor = quad_mesh(
        {glm::vec3(-far, low, far), {far, low, far}, {far, low, -far}, {-far, low, -far}}, {0, 1, 0});
    const Mesh wall =
        quad_mesh({glm::vec3(-far, low + height, z), {far, low + height, z}, {far, low, z}, {-far, low, z}},
                  {0, 0, -1});
    Scene scene = scene_of({floor, wall});
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 200;
    return scene;
}

// The mean of a map over the texels further than `border` from its edges of which counts(x, y) holds.
template <class Counts>
double mean_where(const Image<float>& ao, int border, const Counts& counts) {
    double sum = 0;
    int count = 0;
    for (int y = border; y < ao.size.height - border; ++y) {
        for (int x = border; x < ao.size.width - border; ++x) {
            if (!counts(x, y)) continue;
            sum += static_cast<double>(ao.at(x, y));
            ++count;
        }
    }
    return sum / count;
}

// Over the texels that show something.
inline double mean_inside(const Image<float>& ao, const AoInputs& inputs, int border = 0) {
    return mean_where(ao, border, [&](int x, int y) { return inputs.view_depth.at(x, y) < kInfinity; });
}

// Over the floor of wall_on_floor(), as far as `reach` from the wall.
inline double mean_of_floor(const Image<float>& ao, const AoInputs& inputs, float reach) {
    return mean_where(ao, 0, [&](int x, int y) {
        const float z = inputs.view_depth.at(x, y);
        return inputs.normal.y.at(x, y) > 0.9f && z < 6 && z > 6 - reach;
    });
}

}  // namespace crevice
