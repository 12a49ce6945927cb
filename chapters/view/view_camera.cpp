#include "chapters/view/view_camera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr int kDigits = 7;

struct Axes {
    glm::dvec3 right, forward;  // unit
    double distance;            // of eye and target
};

Axes axes_of(const Camera& camera) {
    const glm::dvec3 towards = camera.target - camera.eye;
    const glm::dvec3 forward = glm::normalize(towards);
    return {glm::normalize(glm::cross(camera.up, forward)), forward, glm::length(towards)};
}

// `forward` turned to the right and up, no steeper than kSteepest_rad.
glm::dvec3 turned(const Axes& axes, double sideways_rad, double upward_rad) {
    const glm::dvec3 level = glm::normalize(glm::dvec3(axes.forward.x, 0, axes.forward.z));
    const glm::dvec3 heading = std::cos(sideways_rad) * level + std::sin(sideways_rad) * axes.right;
    const double slope = std::clamp(std::asin(std::clamp(axes.forward.y, -1.0, 1.0)) + upward_rad,
                                    -kSteepest_rad, kSteepest_rad);
    return std::cos(slope) * heading + glm::dvec3(0, std::sin(slope), 0);
}

std::string point_word(const glm::dvec3& p) {
    return significant_text(p.x, kDigits) + "," + significant_text(p.y, kDigits) + "," +
           significant_text(p.z, kDigits);
}

}  // namespace

Camera orbited(const Camera& camera, double sideways_rad, double upward_rad) {
    const Axes axes = axes_of(camera);
    Camera after = camera;
    after.eye = camera.target - axes.distance * turned(axes, sideways_rad, -upward_rad);
    return after;
}

Camera looked_aside(const Camera& camera, double sideways_rad, double upward_rad) {
    const Axes axes = axes_of(camera);
    Camera after = camera;
    after.target = camera.eye + axes.distance * turned(axes, sideways_rad, upward_rad);
    return after;
}

Camera moved(const Camera& camera, const glm::dvec3& right_up_forward) {
    const Axes axes = axes_of(camera);
    const glm::dvec3 up = glm::cross(axes.forward, axes.right);
    const glm::dvec3 way = axes.distance * (right_up_forward.x * axes.right + right_up_forward.y * up +
                                            right_up_forward.z * axes.forward);
    Camera after = camera;
    after.eye += way;
    after.target += way;
    return after;
}

Camera zoomed(const Camera& camera, double factor) {
    Camera after = camera;
    after.eye = camera.target + factor * (camera.eye - camera.target);
    after.ortho_height *= factor;
    return after;
}

CameraFlags flags_of(const SceneArgument& scene, const Camera& camera, const CameraFlags& flags) {
    CameraFlags after = flags;
    after.eye = point_word(own_coordinates(scene, camera.eye));
    after.target = point_word(own_coordinates(scene, camera.target));
    if (camera.projection == Projection::orthographic)
        after.ortho = significant_text(camera.ortho_height, kDigits);
    return after;
}

}  // namespace crevice
