// The camera: where it stands, what it sees, and the matrices and rays that follow from it.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/base/image.h"

namespace crevice {

enum class Projection { perspective, orthographic };

struct Camera {
    glm::dvec3 eye = glm::dvec3(0, 0, -10);   // world space
    glm::dvec3 target = glm::dvec3(0, 0, 0);  // world space, a point in the middle of the picture
    glm::dvec3 up = glm::dvec3(0, 1, 0);      // world space, not parallel to target - eye
    Projection projection = Projection::perspective;
    double fov_y_rad = 1.0471975511965976;  // (0, pi), here pi / 3; vertical field of view, perspective only
    double ortho_height = 10;               // > 0, scene units the picture is high, orthographic only
    double near_plane = 1;                  // > 0, scene units
    double far_plane = 1000;                // > near_plane, scene units
    bool reversed_z = false;                // near at ndc depth 1 and far at 0
    bool operator==(const Camera&) const = default;
};

// Throws UsageError naming the first member that is out of range or not a number.
void validate(const Camera& camera);

// All that a pass needs of a camera and an image size, rounded to float once, here.
//   relative space: world axes, origin at the eye. Positions are brought there by one exact subtraction, so a
//                   scene far from the world's origin loses nothing.
struct CameraMatrices {
    glm::mat4 clip_from_relative;
    glm::mat4 clip_from_view;
    glm::mat4 view_from_world;
    glm::mat4 relative_from_view;  // a rotation
    glm::mat4 view_from_relative;  // its transpose
    // A view-space position at screen uv in [0,1]^2 and view depth z is
    //   perspective:  ((2u-1) * ray_scale.x * z, (1-2v) * ray_scale.y * z, z);  orthographic: the same
    //                 without z in x, y.
    glm::vec2 ray_scale;
    // ndc_depth = depth_a + depth_b / view_depth (perspective) or depth_a + depth_b * view_depth
    // (orthographic).
    float depth_a = 0, depth_b = 0;
};
CameraMatrices camera_matrices(const Camera& camera, Size size);

}  // namespace crevice
