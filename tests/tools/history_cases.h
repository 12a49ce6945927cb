// What the tests of temporal accumulation look at, and where cameras see things by their own account.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>

#include "rasterizer/draw/normal_depth.h"
#include "ssao/inputs/ao_inputs.h"

namespace crevice {

inline constexpr Size kHistorySize{96, 64};

inline AoInputs inputs_of(const Scene& scene, const Camera& camera, Size size = kHistorySize) {
    return ao_inputs(normal_depth(scene, camera, size), camera, {.point_normals = true, .scale = 1});
}

// The world position of what a texel shows.
inline glm::dvec3 p_world(const AoInputs& inputs, const Camera& camera, int x, int y) {
    const Size size = inputs.size();
    const Vec3<float> p = inputs.rays.p_view((static_cast<float>(x) + 0.5f) / static_cast<float>(size.width),
                                             (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height),
                                             inputs.view_depth.at(x, y));
    const glm::vec3 relative =
        glm::mat3(camera_matrices(camera, size).relative_from_view) * glm::vec3(p.x, p.y, p.z);
    return camera.eye + glm::dvec3(relative);
}

// Where a camera sees a world position: picture widths and heights from the upper left corner.
inline glm::dvec2 uv_of(glm::dvec3 p, const Camera& camera, Size size) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye),
                     right = glm::normalize(glm::cross(camera.up, forward)), up = glm::cross(forward, right);
    const glm::dvec3 from_eye = p - camera.eye;
    const bool perspective = camera.projection == Projection::perspective;
    const double half_height = perspective ? std::tan(0.5 * camera.fov_y_rad) * glm::dot(from_eye, forward)
                                           : 0.5 * camera.ortho_height;
    const double half_width = half_height * size.width / size.height;
    return {0.5 + 0.5 * glm::dot(from_eye, right) / half_width,
            0.5 - 0.5 * glm::dot(from_eye, up) / half_height};
}

}  // namespace crevice
