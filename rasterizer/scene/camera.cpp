#include "rasterizer/scene/camera.h"
#include "rasterizer/scene/exact_projection.h"

#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

namespace {

void require(bool holds, const char* member, const char* what, double value) {
    if (!holds)
        throw UsageError(std::string(member) + ": " + what + " (" + shortest_text(value) +
                         "); choose another");
}

// Of eye and target: what is seen from there is rounded to floats.
constexpr double kFarthest = 1e30;

double largest_of_components(const glm::dvec3& p) {
    return std::fmax(std::fabs(p.x), std::fmax(std::fabs(p.y), std::fabs(p.z)));
}

void require_finite(const char* member, const glm::dvec3& p) {
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), member,
            "x, y and z must be finite numbers, their sum is", p.x + p.y + p.z);
}

// One off-centre-free frustum for both depth directions: with reversed z the roles of the two planes are
// swapped, and the picture is measured on the plane that comes first.
glm::dmat4 clip_from_view_of(const Camera& camera, double aspect) {
    const double first = camera.reversed_z ? camera.far_plane : camera.near_plane;
    const double last = camera.reversed_z ? camera.near_plane : camera.far_plane;
    if (camera.projection == Projection::orthographic) {
        const double top = 0.5 * camera.ortho_height;
        return glm::orthoLH_ZO(-top * aspect, top * aspect, -top, top, first, last);
    }
    const double top = first * tangent(0.5 * camera.fov_y_rad);
    return glm::frustumLH_ZO(-top * aspect, top * aspect, -top, top, first, last);
}

}  // namespace

void validate(const Camera& camera) {
    require_finite("eye", camera.eye);
    require_finite("target", camera.target);
    require_finite("up", camera.up);
    const glm::dvec3 forward = camera.target - camera.eye;
    const double longest = largest_of_components(forward);
    require(longest > 0, "target", "eye and target are the same point, x is", camera.eye.x);
    require(longest <= kFarthest && largest_of_components(camera.eye) <= kFarthest, "eye",
            "eye and target must lie within 1e30 units, the largest coordinate is",
            std::fmax(longest, largest_of_components(camera.eye)));
    const glm::dvec3 along = glm::normalize(forward / longest),
                     upward = camera.up / std::fmax(largest_of_components(camera.up), 1e-300);
    const glm::dvec3 side = glm::cross(upward, along);
    require(glm::dot(side, side) > 1e-12 * glm::dot(upward, upward), "target",
            "the view direction is parallel to up, its y is", along.y);
    require(std::isfinite(camera.near_plane) && camera.near_plane > 0, "near_plane", "near must be above 0",
            camera.near_plane);
    require(std::isfinite(camera.far_plane) && camera.far_plane > camera.near_plane, "far_plane",
            "far must be above near", camera.far_plane);
    if (camera.projection == Projection::orthographic) {
        require(std::isfinite(camera.ortho_height) && camera.ortho_height > 0, "ortho_height",
                "the height of an orthographic picture must be above 0", camera.ortho_height);
    } else {
        require(camera.fov_y_rad > 1e-4 && camera.fov_y_rad < kPi - 1e-4, "fov_y_rad",
                "the vertical field of view must lie between 0.006 and 179.994 degrees",
                camera.fov_y_rad * (180 / kPi));
    }
}

glm::dmat4 clip_from_relative(const Camera& camera, Size size) {
    const glm::dmat4 view_from_world = glm::lookAtLH(camera.eye, camera.target, camera.up);
    return clip_from_view_of(camera, static_cast<double>(size.width) / size.height) *
           glm::dmat4(glm::dmat3(view_from_world));
}

CameraMatrices camera_matrices(const Camera& camera, Size size) {
    validate(camera);
    if (size.width < 1 || size.height < 1) {
        throw UsageError("size: width and height must be at least 1 (" + std::to_string(size.width) + "x" +
                         std::to_string(size.height) + "); choose another");
    }
    const double aspect = static_cast<double>(size.width) / size.height;
    const double n = camera.near_plane, f = camera.far_plane;
    const glm::dmat4 clip_from_view = clip_from_view_of(camera, aspect);
    const glm::dmat4 view_from_world = glm::lookAtLH(camera.eye, camera.target, camera.up);
    const glm::dmat4 view_from_relative = glm::dmat4(glm::dmat3(view_from_world));

    CameraMatrices m;
    m.clip_from_relative = glm::mat4(clip_from_relative(camera, size));
    m.clip_from_view = glm::mat4(clip_from_view);
    m.view_from_world = glm::mat4(view_from_world);
    m.view_from_relative = glm::mat4(view_from_relative);
    m.relative_from_view = glm::transpose(m.view_from_relative);
    m.ray_scale = glm::vec2(1 / clip_from_view[0][0], 1 / clip_from_view[1][1]);
    if (camera.projection == Projection::perspective) {
        m.depth_a = static_cast<float>(camera.reversed_z ? -n / (f - n) : f / (f - n));
        m.depth_b = static_cast<float>(camera.reversed_z ? n * f / (f - n) : -n * f / (f - n));
    } else {
        m.depth_a = static_cast<float>(camera.reversed_z ? f / (f - n) : -n / (f - n));
        m.depth_b = static_cast<float>(camera.reversed_z ? -1 / (f - n) : 1 / (f - n));
    }
    return m;
}

}  // namespace crevice
